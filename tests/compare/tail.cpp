// Probabilities against exact ones.
#include "compare/tail.h"
#include <cmath>
#include <gtest/gtest.h>

namespace nacre::compare {
namespace {

// The bound holds for signs of equal weights, whose sums are binomial; at n = 2 and z = sqrt 2 it is exact, which is
// where its factor comes from.
TEST(Tail, BoundsBinomialSums) {
    for (const int n : {1, 2, 3, 7, 16, 60, 300}) {
        double tail = 0;
        for (int heads = n; 2 * heads > n; --heads) {
            tail += 2 * std::exp(std::lgamma(n + 1) - std::lgamma(heads + 1) - std::lgamma(n - heads + 1) -
                                 n * std::log(2));
            const double z = (2 * heads - n) / std::sqrt(n);
            EXPECT_GE(sign_tail(z) * (1 + 1e-12), tail) << n << ", " << heads;
        }
    }
    EXPECT_NEAR(sign_tail(std::sqrt(2)), 0.5, 1e-12);
    EXPECT_EQ(sign_tail(0), 1);
}

TEST(Tail, IsThatOfANormalTimesItsFactor) {
    EXPECT_NEAR(sign_tail(3), 3.1787 * 2.6998e-3, 1e-6);
    EXPECT_NEAR(sign_tail(-6) / (3.1787 * 1.97318e-9), 1, 1e-4);
}

TEST(Tail, LimitInvertsIt) {
    for (const double p : {0.4, 0.01, 1e-9, 1e-100, 1e-300}) EXPECT_NEAR(sign_tail(sign_limit(p)) / p, 1, 1e-9) << p;
    EXPECT_TRUE(std::isinf(sign_limit(0)));
}

TEST(Tail, SidakCorrects) {
    EXPECT_NEAR(sidak(0.1, 2), 0.19, 1e-12);
    EXPECT_NEAR(sidak(1e-20, 1e6), 1e-14, 1e-20);
    EXPECT_EQ(sidak(1, 5), 1);
    for (const double count : {1., 3., 1e7}) EXPECT_NEAR(sidak(sidak_level(0.01, count), count), 0.01, 1e-10);
}

} // namespace
} // namespace nacre::compare
