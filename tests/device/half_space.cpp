// Walks in a half-space against values known without Monte Carlo (H-functions and discrete ordinates in float64, the
// universal law of Sparre Andersen).
#include "device/probe.h"
#include "oracle/adding_doubling.h"
#include <cmath>
#include <gtest/gtest.h>

namespace nacre::test {
namespace {

using namespace shared;

Probe half_space(float albedo, float g, float bleed) {
    Probe probe;
    probe.albedo = {albedo, albedo, albedo, 0};
    probe.anisotropy = g;
    probe.bleed = bleed;
    return probe;
}

double quick_error(double exact) { return std::max(1e-3 * exact, 2e-4); }

struct Known {
    float albedo, g, bleed;
    double reflectance;
    double error = 0; // of the known value itself
};

const Known lambert_entry[] = {
    {.5f, 0, 0, .1465443807},   {.5f, 0, .5f, .1496789652},     {.5f, 0, 1, .1524930237},  {.9f, 0, 0, .4780244892},
    {.9f, 0, .5f, .4832079736}, {.9f, 0, 1, .4883614567},       {.99f, 0, 0, .7945636529}, {.99f, 0, .5f, .7972926928},
    {.99f, 0, 1, .8005208025},  {.9f, .5f, 0, .36015164},       {.9f, .8f, 0, .21672348},  {.9f, .9f, 0, .13258493},
    {.99f, .8f, 0, .60264779},  {.9f, .8f, .5f, .221501, 1e-5},
};

void check_lambert(bool quick) {
    std::vector<Known> all(std::begin(lambert_entry), std::end(lambert_entry));
    for (const double albedo : {.5, .9}) // backward scattering: from our own float64 solver
        all.push_back({float(albedo), -.5f, 0, half_space_reflectance(albedo, -.5), 1e-6});
    for (const Known &known : all) {
        const double error = quick ? quick_error(known.reflectance) : 1e-4;
        const Walks found = run_walks_to(half_space(known.albedo, known.g, known.bleed), error);
        const std::string what = "alpha " + std::to_string(known.albedo) + " g " + std::to_string(known.g) + " bleed " +
                                 std::to_string(known.bleed);
        Estimate estimate = found.near[0];
        estimate.error = std::hypot(estimate.error, known.error);
        expect_exact(estimate, known.reflectance, error + known.error, what.c_str());
    }
}

TEST(HalfSpace, LambertEntry) { check_lambert(true); }
TEST(LongHalfSpace, LambertEntry) { check_lambert(false); }

void check_universal(bool quick) {
    for (const float bleed : {0.f, .5f, 1.f, 2.f})
        for (const float albedo : {.5f, .9f, .99f}) {
            Probe probe = half_space(albedo, 0, bleed);
            probe.entry = ENTRY_UNIFORM;
            const double r = std::sqrt(1 - double(albedo)), exact = (1 - r) / (1 + r);
            const double error = quick ? quick_error(exact) : 1e-4;
            const Walks found = run_walks_to(probe, error);
            const std::string what = "alpha " + std::to_string(albedo) + " bleed " + std::to_string(bleed);
            expect_exact(found.near[0], exact, error, what.c_str());
        }
}

TEST(HalfSpace, UniversalLaw) { check_universal(true); }
TEST(LongHalfSpace, UniversalLaw) { check_universal(false); }

// P(out after n scatters) = C_n / 4^n, n >= 1, with the Catalan numbers 1, 2, 5, 14, ...: the series of (1-r)/(1+r) in
// the albedo, whatever the law. Albedo 1, so that every walk counts.
TEST(HalfSpace, UniversalLawByScatters) {
    for (const float bleed : {0.f, 1.f, 2.f}) {
        Probe probe = half_space(1, 0, bleed);
        probe.entry = ENTRY_UNIFORM;
        probe.cap = 8; // a white half-space may hold a walk for 1e9 steps; the first counts are exact all the same
        const Walks found = run_walks(probe, 1 << 20);
        EXPECT_EQ(found.by_scatters[0].mean, 0) << "a walk goes in before it comes out";
        double exact = 1;
        for (int n = 1; n < 8; ++n) {
            exact *= 2 * (2.0 * n - 1) / (n + 1) / 4; // C_n = C_(n-1) 2 (2n-1) / (n+1)
            expect_exact(found.by_scatters[std::size_t(n)], exact, 5e-4, ("scatters " + std::to_string(n)).c_str());
        }
    }
}

// Reciprocal flights differ in the first flight: the universal law does not hold for them.
TEST(HalfSpace, ReciprocalUniformEntry) {
    const struct {
        float bleed;
        double reflectance;
    } known[] = {{.5f, .466}, {1, .417}, {2, .340}};
    for (const auto &k : known) {
        Probe probe = half_space(.9f, 0, k.bleed);
        probe.entry = ENTRY_UNIFORM;
        probe.reciprocal = 1;
        const Estimate found = run_walks_to(probe, 4e-4).near[0];
        EXPECT_NEAR(found.mean, k.reflectance, 5e-4 + 4 * found.error) << "bleed " << k.bleed; // known to three digits
    }
}

// <L> = alpha R'(alpha) / R for exponential flights: 3.481416 at alpha .9, g 0.
TEST(HalfSpace, MeanPath) {
    const Walks found = run_walks(half_space(.9f, 0, 0), 1 << 20);
    const double r = .4780244892;
    expect_exact(found.length, 3.481416 * r, 1e-2 * r, "mean path x reflectance");
}

TEST(HalfSpace, EveryChannelSamplingAgrees) {
    for (const ChannelSampling sampling : {CHANNEL_SINGLE, CHANNEL_ALBEDO, CHANNEL_THROUGHPUT, CHANNEL_HERO}) {
        Probe probe; // grey extinction: `single` and `albedo` have no finite error otherwise
        probe.albedo = {.99f, .9f, .5f, 0};
        const Walks found = run_walks_to(probe, 6e-4, sampling);
        const double exact[] = {.7945636529, .4780244892, .1465443807};
        for (std::size_t c = 0; c < 3; ++c)
            expect_exact(found.near[c], exact[c], 6e-4,
                         ("mode " + std::to_string(sampling) + " channel " + std::to_string(c)).c_str());
    }
}

// Chromatic extinction does not change the colour of a half-space: each channel has its own mean free path.
TEST(HalfSpace, ChromaticExtinction) {
    for (const ChannelSampling sampling : {CHANNEL_THROUGHPUT, CHANNEL_HERO})
        for (const float bleed : {0.f, 1.f}) {
            Probe probe;
            probe.sigma = {1, 2.857142857f, 5, 0};
            probe.albedo = {.99f, .9f, .5f, 0};
            probe.bleed = bleed;
            const Walks found = run_walks_to(probe, 2e-3, sampling);
            const double exact[2][3] = {{.7945636529, .4780244892, .1465443807},
                                        {.8005208025, .4883614567, .1524930237}};
            for (std::size_t c = 0; c < 3; ++c)
                expect_exact(found.near[c], exact[bleed > 0][c], 2e-3, ("channel " + std::to_string(c)).c_str());
            EXPECT_LT(found.largest, 20) << "no walk may weigh much more than the channels' number";
        }
}

} // namespace
} // namespace nacre::test
