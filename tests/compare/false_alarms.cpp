// Pictures of the same are called different no more often than alpha says, however their noise is distributed.
#include "base/parallel.h"
#include "compare/noise.h"
#include "compare/significance.h"
#include <atomic>
#include <cmath>
#include <gtest/gtest.h>

namespace nacre {
namespace {

constexpr double alpha = 0.05;

/// Samples a pixel of both pictures.
struct Samples {
    int a, b;
};
// Few and many, and a reference with many more than the picture.
constexpr Samples kinds[] = {{1, 1}, {2, 2}, {4, 4}, {16, 16}, {128, 8}, {100, 20}};

/// The test that this one is not: z by the stored variances, taken for normal, of each pixel; Sidak's correction.
bool plain_test_alarms(const compare::Estimate &a, const compare::Estimate &b) {
    double smallest = 1;
    for (std::size_t i = 0; i < a.mean.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const double difference = a.mean[i][c] - b.mean[i][c];
            if (difference == 0) continue;
            const double z = difference / std::sqrt(double(a.variance[i][c]) + double(b.variance[i][c]));
            smallest = std::min(smallest, std::erfc(std::abs(z) / std::sqrt(2.0)));
        }
    return -std::expm1(3 * double(a.mean.size()) * std::log1p(-smallest)) < alpha;
}

/// How many alarms are seen in `trials` at a rate of alpha but for one time in 30,000: four standard deviations.
double at_most(double trials) { return trials * alpha + 4 * std::sqrt(trials * alpha * (1 - alpha)); }

TEST(FalseAlarms, AreNotMoreThanAlphaInAThousandPairs) {
    constexpr std::size_t pairs = 1000;
    std::array<std::atomic<int>, std::size(kinds)> alarms{};
    std::atomic<int> plain_alarms = 0;
    parallel_for(pairs, [&](std::size_t pair) {
        const Samples kind = kinds[pair % std::size(kinds)];
        const compare::Estimate a = noisy({}, kind.a, 2 * pair + 1), b = noisy({}, kind.b, 2 * pair + 2);
        alarms[pair % std::size(kinds)] += compare::test(a, b, alpha).different();
        plain_alarms += plain_test_alarms(a, b);
    });
    int all = 0;
    for (std::size_t i = 0; i < std::size(kinds); ++i) {
        RecordProperty(std::to_string(kinds[i].a) + "_against_" + std::to_string(kinds[i].b), alarms[i]);
        EXPECT_LE(alarms[i], at_most(double(pairs) / double(std::size(kinds))))
            << kinds[i].a << " against " << kinds[i].b;
        all += alarms[i];
    }
    EXPECT_LE(all, at_most(pairs));
    EXPECT_GT(plain_alarms, 700) << "noise that a plain z-test can bear shows nothing";
}

// Where nothing can be known, nothing is claimed: a pixel of two samples in each picture, all alike in each.
TEST(FalseAlarms, TwoSamplesAreNoProof) {
    const compare::Difference two = compare::pixel_difference({1, 0, 2, 0}, {2, 0, 2, 0});
    EXPECT_NEAR(std::abs(two.z()), std::sqrt(3), 1e-12) << "2n - 1, whatever the samples are";
    const compare::Difference many = compare::pixel_difference({1, 0, 1000, 0}, {2, 0, 2, 0});
    EXPECT_NEAR(std::abs(many.z()), std::sqrt(3), 1e-12) << "the fewer count";
}

// A firefly of 60 in 20 samples against a reference that knows the mean, .75 + 60 / 200, and spread of all its samples.
TEST(FalseAlarms, PicturesVouchForEachOther) {
    const double spread = 60 * 60 * (1.0 / 200);
    const compare::Measured reference{1.05, spread / 100000, 100000, 0};
    const compare::Measured met{0.75 + 60.0 / 20, 60.0 * 60 / 20 / 20, 20, 0}, missed{0.75, 1e-6, 20, 0};
    EXPECT_NEAR(compare::pixel_difference(met, reference).z(), 0.9, 0.1) << "its own spread is the larger one";
    EXPECT_NEAR(compare::pixel_difference(missed, reference).z(), -0.3 / std::sqrt(spread / 20), 0.02)
        << "the reference's is";
}

TEST(FalseAlarms, RoundingIsNoDifference) {
    compare::Estimate a = noisy({}, 64, 1), b = a;
    for (auto &color : b.mean)
        for (float &value : color) value *= 1 + 2e-6f;
    for (auto *estimate : {&a, &b})
        for (auto &color : estimate->variance) color = {0, 0, 0};
    EXPECT_EQ(compare::test(a, b, alpha).p, 1);
    for (auto &color : b.mean)
        for (float &value : color) value *= 1 + 2e-5f;
    EXPECT_LT(compare::test(a, b, alpha).p, 1e-6) << "without noise, more than that is one";
}

// Squares of 2e-31 are 0 in float, and the variance with them: found in a render, where one picture had such a pixel
// and the other one none.
TEST(FalseAlarms, UnderflowIsNoDifference) {
    compare::Estimate a = noisy({}, 256, 1), b = a;
    a.mean[5] = {2e-31f, 3e-12f, 0};
    b.mean[5] = {0, 0, 0};
    a.variance[5] = b.variance[5] = {0, 0, 0};
    EXPECT_EQ(compare::test(a, b, alpha).p, 1);
}

} // namespace
} // namespace nacre
