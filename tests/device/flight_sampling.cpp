// Free flights are drawn as their law says: chi-square of every law, and the mean of ln tau, which exists for every
// tail.
#include "device/chi_square.h"
#include "device/probe.h"
#include "shared/features.h"
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace nacre::test {
namespace {

using namespace shared;

constexpr std::uint32_t samples = 1 << 20;

/// 1 - T in float64 (physics.md, section 1; the reciprocal model's flight from a scatter has the exponent a + 1).
double flown(double tau, double bleed, bool steeper) {
    if (bleed == 0) return -std::expm1(-tau);
    return -std::expm1(-(1 / bleed + (steeper ? 1 : 0)) * std::log1p(bleed * tau));
}

struct Law {
    float bleed;
    std::uint32_t reciprocal, scatters;
    bool steeper() const { return reciprocal && scatters; }
    std::string name() const {
        return "bleed " + std::to_string(bleed) + (reciprocal ? " reciprocal" : " renewal") +
               (scatters ? " from a scatter" : " from the surface");
    }
};

std::vector<Law> laws() {
    std::vector<Law> all{{0, 0, 0}, {0, 1, 1}};
    for (const float bleed : {1e-7f, 1e-3f, .5f, 1.f, 2.f, 10.f})
        for (const std::uint32_t reciprocal : {0u, 1u})
            for (const std::uint32_t scatters : {0u, 1u}) all.push_back({bleed, reciprocal, scatters});
    return all;
}

std::vector<float> draw(const Law &law, std::uint32_t seed, std::uint32_t count = samples, std::uint32_t features = 0) {
    Probe probe;
    probe.bleed = law.bleed;
    probe.reciprocal = law.reciprocal;
    probe.first = law.scatters;
    probe.seed = seed;
    probe.count = count;
    return run_probe("probe_flight", probe, count, 4, CHANNEL_HERO, features);
}

void check(const Law &law, const std::vector<float> &drawn) {
    std::vector<double> u(samples);
    for (std::size_t i = 0; i < samples; ++i) u[i] = flown(drawn[4 * i], law.bleed, law.steeper());
    expect_uniform(u, 512, law.name());
}

TEST(FlightSampling, EveryLaw) {
    std::uint32_t seed = 1;
    for (const Law &law : laws()) check(law, draw(law, seed++));
}

// At bleed 1e4 float holds one flight in a hundred; the others must be infinite, all of them. What it must hold is
// bleed times the depth, which is 1e4 times less.
TEST(FlightSampling, BeyondTheRangeOfFloat) {
    std::uint32_t seed = 50;
    for (const std::uint32_t reciprocal : {0u, 1u}) {
        const Law law{1e4f, reciprocal, 0};
        const std::vector<float> drawn = draw(law, seed++);
        const double held = flown(std::numeric_limits<float>::max() / law.bleed, law.bleed, law.steeper());
        constexpr std::size_t bins = 64;
        std::vector<std::uint64_t> observed(bins + 1);
        for (std::size_t i = 0; i < samples; ++i) {
            const float tau = drawn[4 * i];
            const double u = flown(tau, law.bleed, law.steeper()) / held;
            ++observed[std::isinf(tau) ? bins : std::min(bins - 1, std::size_t(u * bins))];
        }
        std::vector<double> shares(bins, held / bins);
        shares.push_back(1 - held);
        expect_distribution(observed, shares, law.name());
    }
}

// Another material of the scene may bleed: the exponential law is then the one with bleed 0.
TEST(FlightSampling, ExponentialBesideBleed) { check({0, 0, 0}, draw({0, 0, 0}, 99, samples, FEATURE_BLEED)); }

double digamma(double x) {
    double below = 0;
    for (; x < 10; ++x) below += 1 / x;
    return std::log(x) - 1 / (2 * x) - 1 / (12 * x * x) + 1 / (120 * std::pow(x, 4)) - 1 / (252 * std::pow(x, 6)) -
           below;
}

// E[ln tau] = ln a - gamma - psi(k), k the exponent of T: tau / a is beta-prime distributed.
TEST(FlightSampling, MeanLogarithm) {
    constexpr std::uint32_t few = 1 << 18;
    for (const Law &law : laws()) {
        if (law.bleed < .5f || law.bleed > 5) continue; // at 10 float does not hold all depths: one in 10^5 is infinite
        const std::vector<float> drawn = draw(law, 7, few);
        double sum = 0, squares = 0;
        for (std::size_t i = 0; i < few; ++i) {
            const double x = std::log(double(drawn[4 * i]));
            sum += x;
            squares += x * x;
        }
        const double a = 1 / double(law.bleed), mean = sum / few;
        const double exact = std::log(a) - std::numbers::egamma - digamma(a + (law.steeper() ? 1 : 0));
        const double error = std::sqrt((squares / few - mean * mean) / few);
        EXPECT_NEAR(mean, exact, 4 * error) << law.name();
        EXPECT_LT(error, 6e-3) << law.name();
    }
}

} // namespace
} // namespace nacre::test
