// FLIP against values known without it, and against what the authors' own program (flip-evaluator 1.7) says of pictures
// that are formulas.
#include "compare/flip.h"
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace nacre::compare {
namespace {

constexpr int width = 40, height = 30;

std::vector<Color> flat(float grey) { return std::vector<Color>(std::size_t(width) * height, {grey, grey, grey}); }

double mean(const Plane &plane) {
    double sum = 0;
    for (const float value : plane.values) sum += value;
    return sum / double(plane.values.size());
}

/// Waves of colour, and the same with other waves upon them.
struct Waves {
    std::vector<Color> reference, test;
    explicit Waves(double range) {
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                Color r, t;
                for (int c = 0; c < 3; ++c) {
                    const double value = 0.5 + 0.5 * std::sin(0.3 * x + 0.5 * y + 2 * c);
                    const double other = std::min(1.0, value * (1 + 0.2 * std::sin(0.7 * x - 0.2 * y + c)));
                    const double light = std::exp2(range * std::sin(0.2 * x + 0.1 * y));
                    r[std::size_t(c)] = float(value * light);
                    t[std::size_t(c)] = float(other * light);
                }
                reference.push_back(r);
                test.push_back(t);
            }
    }
};

Estimate estimate(std::vector<Color> pixels) {
    Estimate result;
    result.width = width;
    result.height = height;
    result.mean = std::move(pixels);
    return result;
}

TEST(Flip, EqualPicturesAreZero) {
    const Waves waves(0);
    for (const float value : ldr_flip(width, height, waves.test, waves.test).values) ASSERT_EQ(value, 0);
    EXPECT_EQ(mean(hdr_flip(estimate(waves.test), estimate(waves.test))), 0);
}

// Flat pictures have no features. Black and white are 100 apart in L*; green and blue of sRGB, the farthest, are at
// L*a*b* (87.735, -86.183, 83.180) and (32.297, 79.188, -107.860).
TEST(Flip, BlackAndWhite) {
    const double da = -0.87735 * 86.183 - 0.32297 * 79.188, db = 0.87735 * 83.180 + 0.32297 * 107.860;
    const double largest = std::pow(87.735 - 32.297 + std::hypot(da, db), 0.7);
    const double black_white = 0.95 + 0.05 * (std::pow(100, 0.7) - 0.4 * largest) / (0.6 * largest);
    for (const float value : ldr_flip(width, height, flat(0), flat(1)).values) ASSERT_NEAR(value, black_white, 2e-5);
    EXPECT_NEAR(black_white, 0.967388, 2e-5) << "the authors' program";
    // L* of .18 is 49.496, of .2 it is 51.837: below the bend.
    const double greys = 0.95 / (0.4 * largest) * std::pow(51.837 - 49.496, 0.7);
    for (const float value : ldr_flip(width, height, flat(0.18f), flat(0.2f)).values) ASSERT_NEAR(value, greys, 2e-4);
}

TEST(Flip, IsSymmetricForScreens) {
    const Waves waves(0);
    EXPECT_NEAR(mean(ldr_flip(width, height, waves.test, waves.reference)),
                mean(ldr_flip(width, height, waves.reference, waves.test)), 1e-7);
}

TEST(Flip, OfScreensIsTheAuthors) {
    const Waves waves(0);
    const Plane flip = ldr_flip(width, height, waves.test, waves.reference);
    EXPECT_NEAR(mean(flip), 0.206290, 5e-5);
    EXPECT_NEAR(flip.values[7 * width + 11], 0.249302, 2e-4);
    EXPECT_NEAR(flip.values[0], 0.288151, 2e-4);
}

TEST(Flip, OfRendersIsTheAuthors) {
    const Waves waves(4);
    const Exposures exposures = exposures_of(estimate(waves.reference));
    EXPECT_NEAR(exposures.first, -2.597363, 1e-4);
    EXPECT_NEAR(exposures.last, 1.344925, 5e-3) << "theirs interpolates between the two medians";
    EXPECT_EQ(exposures.count, 4);
    const Plane flip = hdr_flip(estimate(waves.test), estimate(waves.reference));
    EXPECT_NEAR(mean(flip), 0.142466, 1e-4);
    EXPECT_NEAR(flip.values[7 * width + 11], 0.147152, 5e-4);
}

TEST(Flip, OfRendersDoesNotKnowTheUnit) {
    const Waves waves(4);
    Estimate test = estimate(waves.test), reference = estimate(waves.reference);
    const double before = mean(hdr_flip(test, reference));
    for (Estimate *picture : {&test, &reference})
        for (Color &color : picture->mean)
            for (float &value : color) value *= 0x1p60f;
    EXPECT_NEAR(mean(hdr_flip(test, reference)), before, 1e-6);
}

TEST(Flip, BlackBackgroundsAndNumbersThatAreNone) {
    Waves waves(0);
    for (std::size_t i = 0; i < waves.reference.size() * 3 / 4; ++i) waves.reference[i] = {0, 0, 0};
    const Exposures exposures = exposures_of(estimate(waves.reference));
    EXPECT_TRUE(std::isfinite(exposures.last)) << "of what is not black";
    const std::vector<Color> black(waves.reference.size(), {0, 0, 0});
    EXPECT_EQ(mean(hdr_flip(estimate(black), estimate(black))), 0);
    waves.test[3][0] = std::numeric_limits<float>::quiet_NaN();
    waves.test[4][0] = std::numeric_limits<float>::infinity();
    for (const float value : hdr_flip(estimate(waves.test), estimate(waves.reference)).values) {
        ASSERT_GE(value, 0);
        ASSERT_LE(value, 1);
    }
}

} // namespace
} // namespace nacre::compare
