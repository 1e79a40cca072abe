// MSE, relMSE and PSNR of pictures whose figures can be worked out by hand.
#include "compare/metrics.h"
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace nacre::compare {
namespace {

Estimate picture(std::vector<std::array<float, 3>> pixels) {
    Estimate estimate;
    estimate.width = int(pixels.size());
    estimate.height = 1;
    estimate.mean = std::move(pixels);
    return estimate;
}

TEST(Metrics, OfAKnownPair) {
    // Differences 1, 0, 0, 0, 0, -2; the reference's mean is 2, its largest value 4.
    const Metrics found = metrics(picture({{3, 1, 2}, {4, 1, 0}}), picture({{2, 1, 2}, {4, 1, 2}}));
    EXPECT_DOUBLE_EQ(found.mse, 5.0 / 6);
    const double floor = 0.01 * 2 * 2;
    EXPECT_NEAR(found.relmse, (1 / (4 + floor) + 4 / (4 + floor)) / 6, 1e-12);
    EXPECT_NEAR(found.psnr, 10 * std::log10(16 / (5.0 / 6)), 1e-12);
}

TEST(Metrics, OfEqualPictures) {
    const Estimate same = picture({{0, 1, 2}});
    EXPECT_EQ(metrics(same, same).mse, 0);
    EXPECT_EQ(metrics(same, same).relmse, 0);
    EXPECT_TRUE(std::isinf(metrics(same, same).psnr));
    const Estimate black = picture({{0, 0, 0}});
    EXPECT_EQ(metrics(black, black).relmse, 0);
    EXPECT_TRUE(std::isinf(metrics(same, black).relmse)) << "no reference to be relative to";
}

TEST(Metrics, RelativeOnesDoNotKnowTheUnit) {
    const Metrics one = metrics(picture({{3, 1, 2}, {4, 1, 0}}), picture({{2, 1, 2}, {4, 1, 2}}));
    const float unit = 0x1p60f;
    const Metrics other = metrics(picture({{3 * unit, unit, 2 * unit}, {4 * unit, unit, 0}}),
                                  picture({{2 * unit, unit, 2 * unit}, {4 * unit, unit, 2 * unit}}));
    EXPECT_DOUBLE_EQ(one.relmse, other.relmse);
    EXPECT_NEAR(one.psnr, other.psnr, 1e-9);
}

TEST(Metrics, LeaveOutWhatIsNoNumber) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_DOUBLE_EQ(metrics(picture({{3, nan, 2}}), picture({{2, 1, 2}})).mse, 0.5);
}

} // namespace
} // namespace nacre::compare
