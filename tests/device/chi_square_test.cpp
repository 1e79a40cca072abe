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

TEST(KolmogorovSmirnov, TablesOfThePercentiles) {
    // Limit of sqrt(n) D: 5 % at 1.3581, 1 % at 1.6276; the median .8276.
    for (const auto &[z, p] : {std::pair{1.3581, .05}, {1.6276, .01}, {.8276, .5}})
        EXPECT_NEAR(kolmogorov_q(z / 1e6, 1e12), p, 1e-4);
    EXPECT_NEAR(kolmogorov_q(1.1799e-6, 1e12), kolmogorov_q(1.1801e-6, 1e12), 1e-3) << "both series";
    EXPECT_EQ(kolmogorov_q(0, 100), 1);
}

TEST(KolmogorovSmirnov, SeesAShiftThatChiSquareDoesNot) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<double> numbers(1 << 20), bent;
    for (double &u : numbers) u = unit(random);
    EXPECT_GE(kolmogorov_smirnov(numbers), 1e-3);
    for (const double u : numbers) bent.push_back(u + .005 * u * (1 - u)); // largest difference 1.25e-3, 1.3 / sqrt(n)
    EXPECT_LT(kolmogorov_smirnov(bent), .5);
    for (double &u : bent) u += .01 * u * (1 - u);
    EXPECT_LT(kolmogorov_smirnov(bent), 1e-4);
    std::vector<std::uint64_t> observed(512);
    for (const double u : bent) ++observed[std::min<std::size_t>(511, std::size_t(u * 512))];
    EXPECT_GE(chi_square(observed, std::vector<double>(512, 1)), 1e-4) << "then chi-square would do";
}

} // namespace
} // namespace nacre::test
