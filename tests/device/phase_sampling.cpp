// Scattered directions follow Henyey and Greenstein, about any axis, in cosine and azimuth.
#include "device/chi_square.h"
#include "device/directions.h"
#include "shared/features.h"
#include <cmath>
#include <gtest/gtest.h>

namespace nacre::test {
namespace {

using namespace shared;

constexpr std::uint32_t samples = 1 << 20;

/// CDF of the cosine, from 1 - cos: with s = sqrt((1-g)^2 + 2 g (1 - cos)), u = 2 xi - 1 = ((1-g^2)/s - 1)/g.
double cumulated(double away, double g) {
    if (g == 0) return 1 - away / 2;
    const double s = std::sqrt((1 - g) * (1 - g) + 2 * g * away);
    return .5 + .5 * ((1 - g) * (1 + g) / s - 1) / g;
}

void check(float g, const Vec3f &axis, std::uint32_t seed, std::uint32_t features = 0) {
    Probe probe;
    probe.anisotropy = g;
    set_axis(probe, axis);
    probe.count = samples;
    probe.seed = seed;
    const std::vector<float> drawn = run_probe("probe_phase", probe, samples, 4, CHANNEL_HERO, features);
    std::vector<double> cosine(samples), turn(samples);
    double longest = 0;
    const Vec3 about = axis.cast<double>();
    for (std::size_t i = 0; i < samples; ++i) {
        const Vec3 d = direction_of(drawn, i);
        // From the nearer of the two poles, where directions lie close together.
        const double away = d.dot(about) > 0 ? .5 * (d - about).squaredNorm() : 2 - .5 * (d + about).squaredNorm();
        cosine[i] = cumulated(away, g);
        turn[i] = azimuth(d, about);
        longest = std::max(longest, std::abs(d.norm() - 1));
    }
    const std::string what = "g " + std::to_string(g) + " about z " + std::to_string(axis.z());
    expect_uniform(cosine, 512, what + ", cosine");
    expect_uniform(cosine, turn, 24, what + ", cosine and azimuth");
    EXPECT_LE(longest, 2e-7) << what;
}

TEST(PhaseSampling, EveryAnisotropyAboutEveryAxis) {
    std::uint32_t seed = 1;
    for (const float g : {-.99f, -.9f, -.5f, 1e-5f, .5f, .8f, .95f, .99f, .999f, -.9999f, -.999f, 1e-6f, .9999f})
        check(g, axes()[seed % axes().size()], seed + 3), ++seed;
    for (const Vec3f &axis : axes()) check(.8f, axis, ++seed);
}

TEST(PhaseSampling, Isotropic) {
    check(0, axes()[2], 21);
    check(0, axes()[3], 22, FEATURE_ANISOTROPY); // in a scene where something else is anisotropic
}

} // namespace
} // namespace nacre::test
