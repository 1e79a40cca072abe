// The specular layer reflects a path with the chance and into the directions that its BSDF says; the rest goes to the
// base. Reflected directions are counted in the plane of the microfacets' slopes, where the lobe has the same shape for
// every roughness, together with the paths that are not reflected.
#include "device/chi_square.h"
#include "device/directions.h"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace nacre::test {
namespace {

constexpr std::uint32_t samples = 1 << 20;
constexpr double ior = 1.5;

double fresnel(double cosine) {
    const double inner = std::sqrt(1 - (1 - cosine * cosine) / (ior * ior));
    const double p = (ior * cosine - inner) / (ior * cosine + inner),
                 s = (cosine - ior * inner) / (cosine + ior * inner);
    return (p * p + s * s) / 2;
}

/// F D G2 / (4 cos_view) of Walter et al. 2007 with height-correlated Smith shadowing: BSDF x cosine of the light.
double reflected(const Vec3 &v, const Vec3 &l, double alpha) {
    if (l.z() <= 0) return 0;
    const Vec3 h = (v + l).normalized();
    const double a2 = alpha * alpha, d = (h.x() * h.x() + h.y() * h.y()) / a2 + h.z() * h.z();
    const auto lambda = [&](const Vec3 &w) {
        return (std::sqrt(1 + a2 * (w.x() * w.x() + w.y() * w.y()) / (w.z() * w.z())) - 1) / 2;
    };
    return fresnel(v.dot(h)) / (std::numbers::pi * a2 * d * d) / (1 + lambda(v) + lambda(l)) / (4 * v.z());
}

struct Drawn {
    std::vector<float> values;
    Vec3 direction(std::size_t i) const { return direction_of(values, 2 * i); }
    double eval(std::size_t i) const { return values[8 * i + 3]; }
    double chance(std::size_t i) const { return values[8 * i + 4]; }
    double base(std::size_t i) const { return values[8 * i + 5]; }
};

Probe layer(const Vec3f &view, const Vec3f &normal, float alpha) {
    Probe probe;
    set_axis(probe, view);
    probe.albedo = {normal.x(), normal.y(), normal.z(), 0};
    probe.sigma = {alpha, float(ior), 0, 0};
    probe.count = samples;
    probe.entry = 2; // of probe_density
    return probe;
}

Vec3f view_at(float degrees) {
    const float t = degrees * std::numbers::pi_v<float> / 180;
    return Vec3f(std::sin(t) * .6f, -std::sin(t) * .8f, std::cos(t)).normalized();
}

/// Bins of microfacet slopes: s = rho^2 / (1 + rho^2), rho = tan / alpha, and the azimuth, which is about the view's.
constexpr std::size_t radial = 16, around = 16, fine = 16;

void check(float alpha, float degrees) {
    const Vec3f view = view_at(degrees);
    const Vec3 v = view.cast<double>();
    const Drawn drawn{run_probe("probe_specular", layer(view, {0, 0, 1}, alpha), samples, 8)};
    const std::string what = "alpha " + std::to_string(alpha) + ", view at " + std::to_string(degrees);

    std::vector<std::uint64_t> observed(radial * around + 1);
    std::mt19937 random(3);
    double worst = 0;
    for (std::size_t i = 0; i < samples; ++i) {
        ASSERT_NEAR(drawn.chance(i) + drawn.base(i), 1, 1e-6) << what;
        const Vec3 l = drawn.direction(i);
        if ((random() + .5) / 4294967296.0 >= drawn.chance(i)) {
            ++observed.back();
            continue;
        }
        const Vec3 h = (v + l).normalized();
        const double rho2 = (h.x() * h.x() + h.y() * h.y()) / (h.z() * h.z() * alpha * alpha);
        const auto r = std::min(radial - 1, std::size_t(rho2 / (1 + rho2) * radial));
        const auto a = std::min(around - 1, std::size_t(azimuth(h, {0, 0, 1}) * around));
        ++observed[r * around + a];
        // Where a light grazes, its cosine has lost digits in the direction already.
        if (l.z() > 1e-3) worst = std::max(worst, std::abs(drawn.eval(i) / reflected(v, l, alpha) - 1));
    }
    // A microfacet's slope is a difference of directions: the narrower the lobe, the fewer digits.
    EXPECT_LE(worst, 1e-4 + 3e-6 / alpha) << what;

    std::vector<double> shares(radial * around + 1);
    double total = 0;
    for (std::size_t i = 0; i < radial * fine; ++i)
        for (std::size_t j = 0; j < around * fine; ++j) {
            const double s = (double(i) + .5) / (radial * fine),
                         t = 2 * std::numbers::pi * (double(j) + .5) / (around * fine);
            const double rho = std::sqrt(s / (1 - s)), tangent = alpha * rho, c = 1 / std::sqrt(1 + tangent * tangent);
            const Vec3 h = c * Vec3(-tangent * std::sin(t), tangent * std::cos(t), 1); // the frame of azimuth() about z
            const double vh = v.dot(h);
            if (vh <= 0) continue;
            const double slopes =
                alpha * alpha / (2 * (1 - s) * (1 - s)) * 2 * std::numbers::pi / double(radial * fine * around * fine);
            const double share = reflected(v, 2 * vh * h - v, alpha) * 4 * vh * c * c * c * slopes;
            shares[i / fine * around + j / fine] += share;
            total += share;
        }
    shares.back() = 1 - total;
    expect_distribution(observed, shares, what);
}

TEST(SpecularSampling, EveryRoughnessFromEveryAngle) {
    for (const float roughness : {.1f, .3f, .6f, 1.f})
        for (const float degrees : {0.f, 45.f, 80.f, 88.f}) check(roughness * roughness, degrees);
    check(1e-3f, 45);
}

// Shading normals that lean against the surface: directions below it are mirrored up, none may be lost.
TEST(SpecularSampling, FoldedAtTheSurface) {
    constexpr std::size_t bins = 20, parts = 24, n = bins * parts;
    std::vector<float> grid(4 * n * n);
    for (std::size_t i = 0; i < n * n; ++i) {
        const double z = (double(i / n) + .5) / n, t = 2 * std::numbers::pi * (double(i % n) + .5) / n;
        const double s = std::sqrt(1 - z * z);
        grid[4 * i] = float(-s * std::sin(t));
        grid[4 * i + 1] = float(s * std::cos(t));
        grid[4 * i + 2] = float(z);
    }
    for (const float tilt : {25.f, 60.f}) {
        const Vec3f normal(std::sin(tilt * .01745329f), 0, std::cos(tilt * .01745329f));
        Probe probe = layer(Vec3f(.5f, .3f, .6f).normalized(), normal.normalized(), .36f);
        const Drawn drawn{run_probe("probe_specular", probe, samples, 8)};
        std::vector<std::uint64_t> observed(bins * bins + 1);
        std::mt19937 random(4);
        for (std::size_t i = 0; i < samples; ++i) {
            if ((random() + .5) / 4294967296.0 >= drawn.chance(i)) {
                ++observed.back();
                continue;
            }
            const Vec3 l = drawn.direction(i);
            ASSERT_GE(l.z(), 0);
            const auto x = std::min(bins - 1, std::size_t(azimuth(l, {0, 0, 1}) * bins));
            ++observed[std::min(bins - 1, std::size_t(l.z() * bins)) * bins + x];
        }
        probe.count = n * n;
        const std::vector<float> values = run_probe("probe_density", probe, n * n, 4, shared::CHANNEL_HERO, 0, grid);
        std::vector<double> shares(bins * bins + 1);
        double total = 0;
        for (std::size_t i = 0; i < n * n; ++i) {
            const double share = values[4 * i + 3] * 2 * std::numbers::pi / double(n * n);
            shares[i / n / parts * bins + i % n / parts] += share;
            total += share;
        }
        shares.back() = 1 - total;
        expect_distribution(observed, shares, "tilt " + std::to_string(tilt));
    }
}

} // namespace
} // namespace nacre::test
