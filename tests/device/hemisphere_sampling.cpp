// The hemisphere samplers, and Lambert's lobe about a shading normal that is tilted against the surface.
#include "device/chi_square.h"
#include "device/directions.h"
#include <cmath>
#include <gtest/gtest.h>

namespace nacre::test {
namespace {

constexpr std::uint32_t samples = 1 << 20;

std::vector<float> draw(std::uint32_t which, const Vec3f &shading, std::uint32_t seed) {
    Probe probe;
    probe.entry = which;
    set_axis(probe, shading);
    probe.count = samples;
    probe.seed = seed;
    return run_probe("probe_hemisphere", probe, samples, 4);
}

TEST(HemisphereSampling, CosineAndUniform) {
    for (const std::uint32_t which : {0u, 1u}) {
        const std::vector<float> drawn = draw(which, {0, 0, 1}, which);
        std::vector<double> height(samples), turn(samples);
        for (std::size_t i = 0; i < samples; ++i) {
            const Vec3 d = direction_of(drawn, i);
            height[i] = which == 0 ? d.z() * d.z() : d.z();
            turn[i] = azimuth(d, {0, 0, 1});
            ASSERT_NEAR(d.norm(), 1, 4e-7);
            ASSERT_GT(d.z(), 0);
        }
        expect_uniform(height, 512, which ? "uniform" : "cosine");
        expect_uniform(height, turn, 32, which ? "uniform, with azimuth" : "cosine, with azimuth");
    }
}

/// Cosine lobe about n, its part below z = 0 mirrored up, per steradian.
double folded(const Vec3 &d, const Vec3 &n) {
    if (d.z() <= 0) return 0;
    const Vec3 mirrored(d.x(), d.y(), -d.z());
    return (std::max(0.0, d.dot(n)) + std::max(0.0, mirrored.dot(n))) / std::numbers::pi;
}

std::vector<Vec3f> tilted() {
    std::vector<Vec3f> normals{{0, 0, 1}};
    for (const float degrees : {20.f, 60.f, 85.f, 90.f}) {
        const float t = degrees * std::numbers::pi_v<float> / 180;
        normals.push_back(Vec3f(std::sin(t) * .6f, std::sin(t) * .8f, std::cos(t)).normalized());
    }
    return normals;
}

TEST(LambertSampling, FoldedLobeFollowsItsPdf) {
    constexpr std::size_t bins = 24, fine = 24;
    std::uint32_t seed = 1;
    for (const Vec3f &normal : tilted()) {
        const Vec3 n = normal.cast<double>();
        const std::vector<float> drawn = draw(2, normal, ++seed);
        std::vector<std::uint64_t> observed(bins * bins);
        std::vector<double> shares(bins * bins);
        for (std::size_t i = 0; i < samples; ++i) {
            const Vec3 d = direction_of(drawn, i);
            ASSERT_GE(d.z(), 0);
            ASSERT_NEAR(drawn[4 * i + 3], folded(d, n), 1e-6);
            const std::size_t x = std::min(bins - 1, std::size_t(azimuth(d, {0, 0, 1}) * bins));
            ++observed[std::min(bins - 1, std::size_t(d.z() * bins)) * bins + x];
        }
        double total = 0;
        for (std::size_t k = 0; k < bins * fine; ++k)
            for (std::size_t j = 0; j < bins * fine; ++j) {
                const double z = (double(k) + .5) / (bins * fine), s = std::sqrt(1 - z * z);
                const double t = 2 * std::numbers::pi * (double(j) + .5) / (bins * fine);
                // The frame of azimuth() about +z: side = z x x = y, then z x y = -x.
                const double share = folded({-s * std::sin(t), s * std::cos(t), z}, n) * 2 * std::numbers::pi /
                                     double(bins * fine * bins * fine);
                shares[k / fine * bins + j / fine] += share;
                total += share;
            }
        EXPECT_NEAR(total, 1, 1e-3) << "normalisation, normal's z " << n.z();
        expect_distribution(observed, shares, "normal's z " + std::to_string(n.z()));
    }
}

// The kernel's pdf is 0 below the surface, and integrates to 1 over the sphere.
TEST(LambertSampling, PdfIsNormalisedOverTheSphere) {
    constexpr std::size_t n = 512;
    std::vector<float> sphere(4 * n * n);
    for (std::size_t i = 0; i < n * n; ++i) {
        const double z = 2 * (double(i / n) + .5) / n - 1, t = 2 * std::numbers::pi * (double(i % n) + .5) / n;
        const double s = std::sqrt(1 - z * z);
        sphere[4 * i] = float(s * std::cos(t));
        sphere[4 * i + 1] = float(s * std::sin(t));
        sphere[4 * i + 2] = float(z);
    }
    for (const Vec3f &normal : tilted()) {
        Probe probe;
        probe.entry = 1;
        probe.count = n * n;
        set_axis(probe, normal);
        const std::vector<float> values = run_probe("probe_density", probe, n * n, 4, shared::CHANNEL_HERO, 0, sphere);
        double sum = 0;
        for (std::size_t i = 0; i < n * n; ++i) sum += values[4 * i + 3] * 4 * std::numbers::pi / double(n * n);
        EXPECT_NEAR(sum, 1, 1e-3) << "normal's z " << normal.z();
    }
}

} // namespace
} // namespace nacre::test
