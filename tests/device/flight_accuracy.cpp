// Flight functions in float against float64 (physics.md, section 7), and against each other.
#include "device/probe.h"
#include "shared/features.h"
#include <cmath>
#include <gtest/gtest.h>

namespace nacre::test {
namespace {

using namespace shared;

struct Exact {
    double transmittance, pdf;
};

Exact exact(double tau, double bleed, double rate) {
    const double depth = bleed > 0 ? std::log1p(bleed * tau) / bleed : tau;
    return {std::exp(-rate * depth), rate * std::exp(-(rate + bleed) * depth)};
}

constexpr float bleeds[] = {0, 1e-8f, 1e-6f, 1e-4f, 1e-3f, .01f, .1f, .5f, 1, 2, 10};
constexpr std::uint32_t count = 1 << 16;

std::vector<float> run(float bleed, std::uint32_t scatters, double low, double high) {
    Probe probe;
    probe.bleed = bleed;
    probe.reciprocal = 1;
    probe.first = scatters;
    probe.count = count;
    if (high > low) {
        probe.a = float(std::log(low));
        probe.b = float(std::log(high));
        probe.c = 1;
    }
    return run_probe("probe_flight", probe, count, 4, CHANNEL_HERO, FEATURE_BLEED);
}

double rate_of(float bleed, std::uint32_t scatters) { return scatters ? double(1.0f + bleed) : 1; }

/// Relative error, in parts of what is allowed: 6e-6 where one path in 10^12 may come, and, as exp(-x) carries x times
/// the error of x, 2e-5 down to where floats are denormal. Devices may flush those to 0.
double part_of_allowed(double found, double exact) {
    if (exact < 1e-37) return found <= 1.01e-37 ? 0 : 2;
    return std::abs(found / exact - 1) / (exact > 1e-12 ? 6e-6 : 2e-5);
}

TEST(FlightAccuracy, TransmittanceAndPdf) {
    for (const float bleed : bleeds)
        for (const std::uint32_t scatters : {0u, 1u}) {
            const std::vector<float> values = run(bleed, scatters, 1e-6, 1e6);
            double worst_t = 0, worst_p = 0;
            for (std::size_t i = 0; i < count; ++i) {
                const Exact e = exact(values[4 * i], bleed, rate_of(bleed, scatters));
                worst_t = std::max(worst_t, part_of_allowed(values[4 * i + 1], e.transmittance));
                worst_p = std::max(worst_p, part_of_allowed(values[4 * i + 2], e.pdf));
            }
            EXPECT_LE(worst_t, 1) << "bleed " << bleed << " scatters " << scatters;
            EXPECT_LE(worst_p, 1) << "bleed " << bleed << " scatters " << scatters;
        }
}

// expm1 of x carries x times the error of x: the tail, where x is large, is as accurate as the logarithm of the number.
TEST(FlightAccuracy, Sample) {
    for (const float bleed : bleeds)
        for (const std::uint32_t scatters : {0u, 1u}) {
            const std::vector<float> values = run(bleed, scatters, 1, 0);
            double worst = 0;
            for (std::size_t i = 0; i < count; ++i) {
                const double depth = -std::log(double(values[4 * i + 3])) / rate_of(bleed, scatters);
                const double tau = bleed > 0 ? std::expm1(bleed * depth) / bleed : depth;
                if (tau < 1e37)
                    worst = std::max(worst, std::abs(values[4 * i] / tau - 1) / (1 + bleed * depth));
                else
                    EXPECT_GE(values[4 * i], 1e37f);
            }
            EXPECT_LE(worst, 1e-6) << "bleed " << bleed << " scatters " << scatters;
        }
}

// Trapezoids in the logarithm; what flies beyond the end is the transmittance there.
TEST(FlightAccuracy, PdfIsNormalised) {
    for (const float bleed : bleeds)
        for (const std::uint32_t scatters : {0u, 1u}) {
            const double low = 1e-8, high = 1e8, step = std::log(high / low) / count;
            const std::vector<float> values = run(bleed, scatters, low, high);
            double sum = 0;
            for (std::size_t i = 0; i < count; ++i) sum += double(values[4 * i]) * values[4 * i + 2] * step;
            EXPECT_NEAR(sum + values[4 * count - 3], 1, 1e-5) << "bleed " << bleed << " scatters " << scatters;
        }
}

} // namespace
} // namespace nacre::test
