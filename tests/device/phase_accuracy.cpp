// Henyey-Greenstein in float against float64 at its extremes (physics.md, section 7).
#include "device/directions.h"
#include "shared/features.h"
#include <cmath>
#include <gtest/gtest.h>

namespace nacre::test {
namespace {

using namespace shared;

constexpr float anisotropies[] = {-.9999f, -.99f, -.5f, -1e-5f, 0, 1e-5f, 1e-3f, .5f, .8f, .95f, .99f, .999f, .9999f};

TEST(PhaseAccuracy, Angle) {
    constexpr std::uint32_t count = 1 << 18;
    for (const float g : anisotropies) {
        Probe probe;
        probe.anisotropy = g;
        probe.count = count;
        const std::vector<float> values = run_probe("probe_phase_angle", probe, count, 4);
        double worst_cosine = 0, worst_sine = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const double h = std::abs(double(g)), u = 2.0 * values[4 * i] - 1, d = 1 + h * u;
            const double away = (1 - h) * (1 - h) * (1 - u) * (1 + h * (1 + u) / 2) / (d * d);
            const double sine = std::sqrt(away * (2 - away)), cosine = g < 0 ? away - 1 : 1 - away;
            worst_sine = std::max(worst_sine, std::abs(values[4 * i + 1] - sine));
            worst_cosine = std::max(worst_cosine, std::abs(values[4 * i + 2] - cosine));
        }
        EXPECT_LE(worst_cosine, 4e-7) << "g " << g;
        EXPECT_LE(worst_sine, 6e-7) << "g " << g;
    }
}

/// Directions about `axis` whose 1 - cos are spread evenly in their logarithm over [1e-14, 2], and that step.
constexpr std::uint32_t count = 1 << 16;
const double lowest = 1e-14, step = std::log(2 / lowest) / count;

std::vector<float> fan(const Vec3 &axis) {
    const Vec3 side = axis.unitOrthogonal(), other = axis.cross(side);
    std::vector<float> directions(4 * count);
    for (std::size_t i = 0; i < count; ++i) {
        const double away = lowest * std::exp(step * (double(i) + .5)), sine = std::sqrt(away * (2 - away)),
                     turn = double(i);
        const Vec3 d = (1 - away) * axis + sine * (std::cos(turn) * side + std::sin(turn) * other);
        for (int c = 0; c < 3; ++c) directions[4 * i + std::size_t(c)] = float(d[c]);
    }
    return directions;
}

std::vector<float> densities(float g, const Vec3f &axis) {
    Probe probe;
    probe.anisotropy = g;
    set_axis(probe, axis);
    probe.count = count;
    return run_probe("probe_density", probe, count, 4, CHANNEL_HERO, FEATURE_ANISOTROPY, fan(axis.cast<double>()));
}

TEST(PhaseAccuracy, Pdf) {
    for (const float g : anisotropies)
        for (const Vec3f &axis : axes()) {
            const std::vector<float> values = densities(g, axis);
            double worst = 0;
            for (std::size_t i = 0; i < count; ++i) {
                const double away = .5 * (direction_of(values, i) - axis.cast<double>()).squaredNorm(), h = g;
                const double d = (1 - h) * (1 - h) + 2 * h * away;
                const double exact = (1 - h) * (1 + h) / (4 * std::numbers::pi * d * std::sqrt(d));
                // At backward peaks d is a small difference: its error is that of 1 - cos near 2.
                worst = std::max(worst, std::abs(values[4 * i + 3] / exact - 1) * std::min(1.0, d));
            }
            EXPECT_LE(worst, 1e-6) << "g " << g << " about z " << axis.z();
        }
}

TEST(PhaseAccuracy, PdfIsNormalised) {
    for (const float g : anisotropies) {
        if (g < -.9f) continue; // the backward peak needs the mirrored fan: checked by the values above
        const std::vector<float> values = densities(g, {0, 0, 1});
        double sum = 0;
        for (std::size_t i = 0; i < count; ++i)
            sum += 2 * std::numbers::pi * lowest * std::exp(step * (double(i) + .5)) * step * values[4 * i + 3];
        EXPECT_NEAR(sum, 1, 2e-6) << "g " << g;
    }
}

} // namespace
} // namespace nacre::test
