// Russian roulette of walks: how many survive, and with which weights, so that their sum stays on average what it was.
#include "device/chi_square.h"
#include "device/probe.h"
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace nacre::test {
namespace {

constexpr std::uint32_t samples = 1 << 21;

struct Outcome {
    std::uint64_t survivors = 0;
    double threshold = 0; // of the largest weight, where any survived
};

/// Plays with the weights r, g, b and expects those of every survivor to be as they were, or raised to the threshold.
Outcome play(float r, float g, float b, std::uint32_t seed) {
    Probe probe;
    probe.sigma = {r, g, b, 0};
    probe.count = samples;
    probe.seed = seed;
    const std::vector<float> out = run_probe("probe_roulette", probe, samples, 4);
    Outcome outcome;
    for (std::size_t i = 0; i < samples; ++i)
        if (out[4 * i + 3] > 0) {
            outcome.threshold = double(out[4 * i + 3]);
            ++outcome.survivors;
            const double heaviest = std::max({r, g, b}), scale = std::max(1., outcome.threshold / heaviest);
            EXPECT_NEAR(out[4 * i], r * scale, 4e-7 * r * scale);
            EXPECT_NEAR(out[4 * i + 1], g * scale, 4e-7 * g * scale);
            EXPECT_NEAR(out[4 * i + 2], b * scale, 4e-7 * b * scale);
            if (testing::Test::HasFailure()) break;
        }
    return outcome;
}

TEST(RouletteSampling, SurvivorsMakeUpForTheLost) {
    std::uint32_t seed = 1;
    for (const float heaviest : {1e-4f, 1e-3f, .01f, .05f, .1f, .15f, .199f, .1999999f})
        for (const float other : {0.f, .3f, 1.f}) {
            const Outcome found = play(other * heaviest, heaviest, .5f * other * heaviest, ++seed);
            const double chance = heaviest / found.threshold;
            expect_distribution({found.survivors, samples - found.survivors}, {chance, 1 - chance},
                                "heaviest " + std::to_string(heaviest) + ", others " + std::to_string(other));
        }
}

TEST(RouletteSampling, Ends) {
    const float infinite = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    for (const float heavy : {.2f, .5f, 1.f, 4.f, 1e30f}) EXPECT_EQ(play(heavy, 0, 0, 1).survivors, samples) << heavy;
    EXPECT_EQ(play(0, 0, 0, 1).survivors, 0u);
    EXPECT_LE(play(1e-30f, 1e-38f, 0, 1).survivors, 1u);
    EXPECT_EQ(play(nan, 1, 1, 1).survivors, 0u);
    EXPECT_EQ(play(1, 1, nan, 1).survivors, 0u);
    EXPECT_EQ(play(infinite, -infinite, 0, 1).survivors, 0u);
}

} // namespace
} // namespace nacre::test
