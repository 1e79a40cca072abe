// What is different is found.
#include "compare/noise.h"
#include "compare/significance.h"
#include <gtest/gtest.h>
#include <limits>

namespace nacre {
namespace {

constexpr double alpha = 1e-3;

TEST(Power, BrightnessOfThePictureIsFound) {
    const Noise noise{.width = 64, .height = 64};
    const compare::Estimate reference = noisy(noise, 64, 1);
    const compare::Verdict verdict = compare::test(noisy({64, 64, 1.05}, 64, 2), reference, alpha);
    EXPECT_TRUE(verdict.different());
    EXPECT_EQ(verdict.picture.beyond, 3u) << "each channel";
    EXPECT_GT(verdict.picture.z, 0) << "A is brighter";
    EXPECT_FALSE(compare::test(noisy(noise, 64, 2), reference, alpha).different());
}

/// A picture whose noise is small, with its twin.
struct Twins {
    compare::Estimate a = noisy({48, 40}, 64, 1), b = noisy({48, 40}, 64, 2);
    Twins() {
        for (compare::Estimate *picture : {&a, &b})
            for (std::size_t i = 0; i < picture->mean.size(); ++i) {
                picture->mean[i] = {1, 1, 1};
                picture->variance[i] = {1e-4f, 1e-4f, 1e-4f};
            }
    }
};

TEST(Power, OnePixelIsFoundAndNamed) {
    Twins twins;
    twins.b.mean[17 * 48 + 33][1] = 1.2f;
    const compare::Verdict verdict = compare::test(twins.a, twins.b, alpha);
    EXPECT_TRUE(verdict.different());
    EXPECT_EQ(verdict.pixels.tested, 48u * 40 * 3);
    EXPECT_EQ(verdict.pixels.beyond, 1u);
    EXPECT_EQ(verdict.pixels.x, 33);
    EXPECT_EQ(verdict.pixels.y, 17);
    EXPECT_EQ(verdict.pixels.channel, 1);
    // sqrt(d^2 / (2 v + d^2 / 127)), B is brighter
    EXPECT_NEAR(verdict.pixels.z, -std::sqrt(0.04 / (2e-4 + 0.04 / 127)), 1e-3);
    EXPECT_EQ(verdict.tiles.beyond + verdict.picture.beyond, 0u) << "one of many pixels is not enough for these";
}

TEST(Power, OneTileIsFoundAndNamed) {
    Twins twins;
    for (int y = 32; y < 40; ++y) // the last row of tiles is cut off
        for (int x = 16; x < 32; ++x) twins.a.mean[std::size_t(y * 48 + x)][2] *= 1.012f;
    const compare::Verdict verdict = compare::test(twins.a, twins.b, alpha);
    EXPECT_TRUE(verdict.different());
    EXPECT_EQ(verdict.tiles.tested, 9u * 3);
    EXPECT_EQ(verdict.tiles.beyond, 1u);
    EXPECT_EQ(verdict.tiles.x, 16);
    EXPECT_EQ(verdict.tiles.y, 32);
    EXPECT_EQ(verdict.tiles.channel, 2);
    EXPECT_NEAR(verdict.tiles.z, 0.012 * std::sqrt(16 * 8 / 2e-4), 0.05);
    EXPECT_EQ(verdict.pixels.beyond, 0u);
}

// Of the mean of the picture: sum of differences over the root of the sum of variances.
TEST(Power, ThePictureIsHeldAgainstItsVariances) {
    Twins twins;
    for (auto &color : twins.a.mean) color[0] *= 1.002f;
    const compare::Verdict verdict = compare::test(twins.a, twins.b, alpha);
    EXPECT_NEAR(verdict.channels[0].z, 0.002 * std::sqrt(48 * 40 / 2e-4), 0.02);
    EXPECT_NEAR(verdict.channels[0].error, std::sqrt(2e-4 / (48 * 40)), 1e-8);
    EXPECT_NEAR(verdict.channels[0].mean_a, 1.002, 1e-6);
    EXPECT_NEAR(verdict.channels[1].z, 0, 1e-12);
    EXPECT_TRUE(verdict.different());
}

TEST(Power, NumbersThatAreNoneAreADifference) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        Twins twins;
        twins.a.mean[48 + 7][1] = twins.b.mean[48 + 7][1] = bad;
        const compare::Verdict verdict = compare::test(twins.a, twins.b, alpha);
        EXPECT_EQ(verdict.not_finite, 1u);
        EXPECT_EQ(verdict.not_finite_x, 7);
        EXPECT_EQ(verdict.not_finite_y, 1);
        EXPECT_TRUE(verdict.different());
        EXPECT_EQ(verdict.p, 1) << "the others are alike";
    }
}

TEST(Power, PixelsWithoutSamplesAreNotTested) {
    Twins twins;
    twins.b.mean[3] = {0, 0, 0};
    twins.b.samples[3] = 0;
    const compare::Verdict verdict = compare::test(twins.a, twins.b, alpha);
    EXPECT_EQ(verdict.untested, 1u);
    EXPECT_EQ(verdict.pixels.tested, (48u * 40 - 1) * 3);
    EXPECT_FALSE(verdict.different());
}

} // namespace
} // namespace nacre
