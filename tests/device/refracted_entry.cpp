// Paths that a surface of microfacets does not reflect enter in the directions of Walter et al. 2007, "Microfacet
// Models for Refraction through Rough Surfaces": counted against their density, integrated here in float64.
#include "device/chi_square.h"
#include "device/directions.h"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace nacre::test {
namespace {

constexpr std::uint32_t samples = 1 << 20, few = 1 << 17;

/// The layer: GGX of `alpha` about `normal`, index `ior`, seen from `view`, all unit vectors outside. The surface
/// itself faces (0, 0, 1).
struct Interface {
    Vec3 view, normal;
    double alpha, ior;

    double lambda(const Vec3 &w) const {
        const double z = w.dot(normal);
        return (std::sqrt(1 + alpha * alpha * (1 / (z * z) - 1)) - 1) / 2;
    }

    double fresnel(double cosine) const {
        const double inner = std::sqrt(1 - (1 - cosine * cosine) / (ior * ior));
        const double p = (ior * cosine - inner) / (ior * cosine + inner),
                     s = (cosine - ior * inner) / (cosine + ior * inner);
        return (p * p + s * s) / 2;
    }

    /// Density of the entry `t`, per steradian: of visible facets (Heitz 2018) times the Jacobian of Snell's law
    /// (Walter, eq 17), less what its facet reflects.
    double one(const Vec3 &t) const {
        const Vec3 sum = -(view + ior * t), h = sum.normalized();
        const double vh = view.dot(h), hz = h.dot(normal), th = t.dot(h);
        if (vh <= 0 || hz <= 0 || th >= 0) return 0;
        const double a2 = alpha * alpha, d = (1 - hz * hz) / a2 + hz * hz;
        const double facets = vh / (std::numbers::pi * a2 * d * d) / (1 + lambda(view)) / view.dot(normal);
        const Vec3 l = 2 * vh * h - view;
        const double both = l.dot(normal) <= 0 ? 0 : (1 + lambda(view)) / (1 + lambda(view) + lambda(l));
        return facets * (1 - fresnel(vh) * both) * ior * ior * -th / sum.squaredNorm();
    }

    /// With what the geometric normal mirrors in.
    double density(const Vec3 &t) const { return one(t) + one({t.x(), t.y(), -t.z()}); }

    Probe probe(std::uint32_t count = samples) const {
        Probe probe;
        set_axis(probe, view.cast<float>());
        probe.albedo = {float(normal.x()), float(normal.y()), float(normal.z()), 0};
        probe.sigma = {float(alpha), float(ior), 0, 0};
        probe.count = count;
        return probe;
    }
};

Vec3 tilted(double degrees, double x = .6, double y = -.8) {
    const double t = degrees * std::numbers::pi / 180;
    return {std::sin(t) * x, std::sin(t) * y, std::cos(t)};
}

/// Lambert's azimuthal projection about (0, 0, -1), which keeps areas: the hemisphere inside is the disc of radius
/// sqrt(2).
Vec2 project(const Vec3 &t) { return Vec2(t.x(), t.y()) * std::sqrt(2 / (1 - t.z())); }
Vec3 unproject(const Vec2 &p) {
    const Vec2 side = p * std::sqrt(1 - p.squaredNorm() / 4);
    return {side.x(), side.y(), p.squaredNorm() / 2 - 1};
}

// Counts in squares about the way through a smooth surface, what is reflected or falls elsewhere in one bin.
void check(const Interface &layer) {
    constexpr int bins = 24, parts = 16;
    const double half = std::min(std::sqrt(2.), 4 * layer.alpha), size = 2 * half / bins;
    const double tangent = layer.view.head<2>().norm() / layer.ior;
    const Vec2 middle =
        project({-layer.view.x() / layer.ior, -layer.view.y() / layer.ior, -std::sqrt(1 - tangent * tangent)});
    const Vec2 corner = (half < 1 ? middle : Vec2(0, 0)) - Vec2(half, half);
    const auto bin_of = [&](const Vec3 &t) -> std::size_t {
        const Vec2 p = (project(t) - corner) / size;
        if (p.x() < 0 || p.y() < 0 || p.x() >= bins || p.y() >= bins) return bins * bins;
        const Vec2 near = corner + size * Vec2(std::floor(p.x()), std::floor(p.y())), far = near + Vec2(size, size);
        const bool whole = near.cwiseAbs().cwiseMax(far.cwiseAbs()).squaredNorm() < 2;
        return whole ? std::size_t(p.y()) * bins + std::size_t(p.x()) : bins * bins;
    };
    const std::string what =
        fmt::format("alpha {} ior {} view {} normal {}", layer.alpha, layer.ior, layer.view.z(), layer.normal.z());

    const std::vector<float> drawn = run_probe("probe_refracted", layer.probe(), samples, 4);
    std::vector<std::uint64_t> observed(bins * bins + 1);
    std::mt19937 random(5);
    for (std::size_t i = 0; i < samples; ++i) {
        const Vec3 t = direction_of(drawn, i);
        ASSERT_LE(t.z(), 0) << what;
        const bool enters = (random() + .5) / 4294967296.0 < double(drawn[4 * i + 3]);
        ++observed[enters ? bin_of(t) : bins * bins];
    }

    std::vector<double> shares(bins * bins + 1);
    double total = 0;
    const double step = size / parts;
    for (int j = 0; j < bins * parts; ++j)
        for (int i = 0; i < bins * parts; ++i) {
            const Vec2 p = corner + step * Vec2(i + .5, j + .5);
            if (p.squaredNorm() >= 2) continue;
            const Vec3 t = unproject(p);
            const std::size_t bin = bin_of(t);
            if (bin == bins * bins) continue;
            shares[bin] += layer.density(t) * step * step;
            total += layer.density(t) * step * step;
        }
    shares.back() = 1 - total;
    ASSERT_GT(shares.back(), 0) << what << ": the density is too large";
    ASSERT_GT(total, .5) << what << ": the bins see too little";
    expect_distribution(observed, shares, what);
}

TEST(RefractedEntry, EveryRoughnessFromEveryAngle) {
    for (const double roughness : {.2, .3, .6, 1.})
        for (const double degrees : {0., 45., 75.}) check({tilted(degrees), {0, 0, 1}, roughness * roughness, 1.5});
    check({tilted(60), {0, 0, 1}, .2, 1.1});
    check({tilted(30), {0, 0, 1}, .2, 3});
}

// Shading normals that lean: what they send out by the geometric normal is mirrored in, none is lost.
TEST(RefractedEntry, FoldedAtTheSurface) {
    for (const double lean : {25., 60.}) check({Vec3(.5, .3, .6).normalized(), tilted(lean, 1, 0), .5, 1.3});
}

TEST(RefractedEntry, StraightOnWithoutAnInterface) {
    for (const double degrees : {0., 45., 89.})
        for (const double alpha : {1e-3, .1, 1.}) {
            const Interface layer{tilted(degrees), {0, 0, 1}, alpha, 1};
            const std::vector<float> drawn = run_probe("probe_refracted", layer.probe(few), few, 4);
            double worst = 0;
            for (std::size_t i = 0; i < few; ++i) worst = std::max(worst, (direction_of(drawn, i) + layer.view).norm());
            EXPECT_LE(worst, 2e-6) << "alpha " << alpha << " view " << degrees;
        }
}

TEST(RefractedEntry, SmoothIsSnell) {
    for (const double ior : {1.2, 1.5, 3.}) {
        const Interface layer{tilted(60), {0, 0, 1}, 1e-3, ior};
        const std::vector<float> drawn = run_probe("probe_refracted", layer.probe(few), few, 4);
        Vec3 mean(0, 0, 0);
        for (std::size_t i = 0; i < few; ++i) mean += direction_of(drawn, i) / few;
        const Vec3 exact(-layer.view.x() / ior, -layer.view.y() / ior, -std::sqrt(1 - .75 / (ior * ior)));
        EXPECT_LE((mean - exact).norm(), 1e-4) << "ior " << ior;
    }
}

// Unit vectors into the surface, no NaN, wherever the layer is seen from.
TEST(RefractedEntry, Extremes) {
    for (const double alpha : {1e-3, 1.})
        for (const double degrees : {0., 88., 89.94})
            for (const double ior : {1., 1.0001, 1.5, 100.}) {
                const Interface layer{tilted(degrees), {0, 0, 1}, alpha, ior};
                const std::vector<float> drawn = run_probe("probe_refracted", layer.probe(few), few, 4);
                std::size_t bad = 0;
                for (std::size_t i = 0; i < few; ++i) {
                    const Vec3 t = direction_of(drawn, i);
                    bad += std::abs(t.norm() - 1) <= 1e-6 && t.z() < 0 && drawn[4 * i + 3] >= 0 && drawn[4 * i + 3] <= 1
                               ? 0
                               : 1;
                }
                EXPECT_EQ(bad, 0u) << "alpha " << alpha << " view " << degrees << " ior " << ior;
            }
}

} // namespace
} // namespace nacre::test
