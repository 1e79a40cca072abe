// Walks in slabs and spheres against known values.
#include "device/probe.h"
#include <cmath>
#include <gtest/gtest.h>

namespace nacre::test {
namespace {

using namespace shared;

Probe body(float albedo, float thickness, float g = 0, float bleed = 0) {
    Probe probe;
    probe.albedo = {albedo, albedo, albedo, 0};
    probe.thickness = thickness;
    probe.anisotropy = g;
    probe.bleed = bleed;
    return probe;
}

TEST(Slab, ReflectanceAndTransmittance) {
    const struct {
        float g;
        double reflectance, transmittance;
    } known[] = {{0, .43714692, .26558129}, {.8f, .16223325, .53081586}};
    for (const auto &k : known) {
        const Walks found = run_walks(body(.9f, 2, k.g), 1 << 20);
        expect_exact(found.near[0], k.reflectance, 4e-4, "reflectance");
        expect_exact(found.far[0], k.transmittance, 5e-4, "transmittance");
    }
}

TEST(Sphere, EscapeAlbedo) {
    expect_exact(run_walks(body(.9f, -1), 1 << 20).near[0], .87800616, 3e-4, "radius 1");
    expect_exact(run_walks(body(.9f, -5), 1 << 20).near[0], .62348458, 5e-4, "radius 5");
}

TEST(Sphere, ZeroScatter) {
    for (const double tau : {1.0, 5.0}) {
        const double exponential = (1 - (1 + 2 * tau) * std::exp(-2 * tau)) / (2 * tau * tau);
        const double davis_xu = 1 / tau - std::log(1 + 2 * tau) / (2 * tau * tau);
        expect_exact(run_walks(body(.5f, float(-tau)), 1 << 20).unscattered, exponential, 5e-4, "bleed 0");
        expect_exact(run_walks(body(.5f, float(-tau), 0, 1), 1 << 20).unscattered, davis_xu, 5e-4, "bleed 1");
    }
}

// Without absorption everything comes out again, whatever the law, the phase function and the way channels are drawn.
TEST(Sphere, Furnace) {
    for (const float g : {-.5f, 0.f, .8f, .95f})
        for (const float bleed : {0.f, .5f, 1.f, 2.f})
            for (const std::uint32_t reciprocal : {0u, 1u})
                for (const ChannelSampling sampling : {CHANNEL_ALBEDO, CHANNEL_THROUGHPUT, CHANNEL_HERO}) {
                    Probe probe = body(1, -3, g, bleed);
                    probe.reciprocal = reciprocal;
                    const Walks found = run_walks(probe, 1 << 12, sampling);
                    for (const Estimate &channel : found.near) EXPECT_NEAR(channel.mean, 1, 1e-5) << g << " " << bleed;
                }
}

// The mean way through a body without absorption is 4 V / S = 4 r / 3: for exponential and reciprocal flights, not for
// the memo's (sphere of radius 5, bleed 1: -18.1 %).
TEST(Sphere, MeanPath) {
    const double exact = 4.0 / 3 * 5;
    expect_exact(run_walks(body(1, -5), 1 << 20).length, exact, 3e-2, "exponential");
    expect_exact(run_walks(body(1, -5, .8f), 1 << 20).length, exact, 3e-2, "exponential, g .8");
    Probe probe = body(1, -5, 0, 1);
    const Estimate renewal = run_walks(probe, 1 << 20).length;
    EXPECT_NEAR(renewal.mean / exact, 1 - .181, 1e-3 + 4 * renewal.error / exact); // known to three digits
    probe.reciprocal = 1;
    expect_exact(run_walks(probe, 1 << 20).length, exact, 3e-2, "reciprocal");
}

} // namespace
} // namespace nacre::test
