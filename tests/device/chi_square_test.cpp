// The test's own tools: a broken yardstick would pass everything.
#include "device/chi_square.h"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace nacre::test {
namespace {

TEST(ChiSquare, IncompleteGamma) {
    for (const double x : {1e-6, .1, 1.0, 1.4, 1.6, 10.0, 50.0}) {
        EXPECT_NEAR(gamma_q(1, x), std::exp(-x), 1e-12) << x;
        EXPECT_NEAR(gamma_q(.5, x), std::erfc(std::sqrt(x)), 1e-12) << x;
        EXPECT_NEAR(gamma_q(3, x), std::exp(-x) * (1 + x + x * x / 2), 1e-12) << x;
    }
    EXPECT_NEAR(gamma_q(500, 500), .494053, 1e-6); // 1/2 - 1/(3 sqrt(2 pi a))
}

TEST(ChiSquare, TablesOfThePercentiles) {
    // 5 % of one degree of freedom is at 3.841: 1e6 in two bins, off by sqrt(3.841 * 1e6) / 2.
    EXPECT_NEAR(chi_square({500980, 499020}, {1, 1}), .05, 1e-4);
    EXPECT_EQ(chi_square({500000, 500000}, {1, 1}), 1);
}

TEST(ChiSquare, SeesOneBinInAHundred) {
    std::mt19937 random(1);
    std::vector<std::uint64_t> observed(100);
    for (int i = 0; i < 1000000; ++i) ++observed[random() % 100];
    std::vector<double> shares(100, 1);
    EXPECT_GE(chi_square(observed, shares), 1e-3);
    shares[7] *= 1.12; // 12 standard deviations
    EXPECT_LT(chi_square(observed, shares), 1e-4);
}

TEST(ChiSquare, BinsThatExpectNothingMustBeEmpty) {
    EXPECT_EQ(chi_square({1000, 100, 1000}, {1, 0, 1}), 0);
    EXPECT_GT(chi_square({1000, 0, 1000}, {1, 0, 1}), .9);
}

} // namespace
} // namespace nacre::test
