// Profiles of the diffusion models: what they integrate to, how radii and lines are drawn, how a colour is split into
// lobes.
#include "device/chi_square.h"
#include "device/diffusion_probe.h"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace nacre::test {
namespace {

using namespace shared;

constexpr int models[] = {MODEL_DIPOLE, MODEL_BETTER_DIPOLE, MODEL_BURLEY};

struct Case {
    DiffusionProbe probe;
    ExactProfile exact;
};

/// Albedo and colour from black to white, forward and backward scattering, all with sigma_t' = 1.
std::vector<Case> cases() {
    std::vector<Case> all;
    for (const int model : models)
        for (const float albedo : {0.f, .1f, .5f, .9f, .99f, 1.f})
            for (const float g : {0.f, .8f, -.5f}) {
                DiffusionProbe probe;
                probe.model = model;
                probe.albedo = probe.color = albedo;
                probe.g = g;
                probe.sigma.x = 1 / (1 - albedo * g);
                all.push_back({probe, {model, double(albedo) * (1 - g) / (1 - double(albedo) * g), albedo}});
            }
    return all;
}

// Both the profile and the density of radii, by trapezia in ln r: to 1 over the plane, and at every radius as the
// papers say.
TEST(DiffusionProfile, IntegratesToTheColor) {
    constexpr std::size_t n = 16384;
    const double low = std::log(1e-7), step = (std::log(1e7) - low) / n;
    std::vector<float> radii(4 * n);
    for (std::size_t i = 0; i < n; ++i) radii[4 * i] = float(std::exp(low + step * double(i)));
    for (Case c : cases()) {
        SCOPED_TRACE(c.exact.name());
        c.probe.direct = 1;
        c.probe.count = n;
        const std::vector<float> found = run_diffusion("probe_profile", c.probe, 4, radii);
        double pdf = 0, eval = 0, worst = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const double r = found[4 * i], ring = 2 * std::numbers::pi * r * r * step;
            pdf += found[4 * i + 1] * ring;
            eval += found[4 * i + 2] * ring;
            if (c.exact.total() > 0 && r > 1e-5)
                worst = std::max(worst, std::abs(found[4 * i + 2] - c.exact.reflectance(r) / c.exact.total()) * ring);
        }
        EXPECT_NEAR(pdf, 1, 1e-4);
        EXPECT_NEAR(eval, 1, 1e-4);
        EXPECT_LE(worst, 1e-6 * step / 1e-3) << "of the light, in one ring";
    }
}

TEST(DiffusionProfile, RadiiAreDrawnWithTheirDensity) {
    constexpr std::uint32_t samples = 1 << 20;
    for (Case c : cases()) {
        if (c.probe.g != 0) continue; // the shape has it in the reduced albedo alone
        c.probe.count = samples;
        c.probe.seed = std::uint32_t(100 * c.probe.albedo) + 7;
        const std::vector<float> found = run_diffusion("probe_profile", c.probe, 4);
        std::vector<double> u(samples);
        for (std::size_t i = 0; i < samples; ++i) u[i] = c.exact.drawn_within(found[4 * i]);
        expect_uniform(u, 512, c.exact.name());
    }
}

// The parts of a colour: they add up to it, the multiple lobe is the integral of R at that albedo, the single one
// exact.
TEST(DiffusionLobes, AddUpToTheColor) {
    constexpr std::size_t n = 401;
    for (const int model : models)
        for (const float g : {0.f, .8f, -.5f, .95f}) {
            DiffusionProbe probe;
            probe.model = model;
            probe.g = g;
            probe.count = n;
            std::vector<float> colors(4 * n);
            for (std::size_t i = 0; i < n; ++i) colors[4 * i] = float(i) / (n - 1);
            const std::vector<float> found = run_diffusion("probe_lobes", probe, 4, colors);
            const double single = exact_single_scattering(g);
            for (std::size_t i = 0; i < n; ++i) {
                const double albedo = found[4 * i], reduced = albedo * (1 - g) / (1 - albedo * g);
                ASSERT_NEAR(found[4 * i + 1] + found[4 * i + 2], colors[4 * i], 3e-6) << model << " " << g;
                if (model == MODEL_BURLEY) continue;
                ASSERT_GE(albedo, 0);
                ASSERT_LT(albedo, 1);
                ASSERT_NEAR(found[4 * i + 1], albedo * single, 1e-4) << g;
                const ExactProfile exact{model, reduced, 0};
                // At g = .95 the last digit of a bright albedo is worth that much.
                ASSERT_NEAR(found[4 * i + 2], exact.total(), g < .9f ? 1e-4 : 1e-3)
                    << model << " " << g << " " << albedo;
            }
        }
}

// Given as albedo, white is white: the lobes never bring more than comes in.
TEST(DiffusionLobes, OfAlbedosStayBelowOne) {
    constexpr std::size_t n = 101;
    for (const int model : models) {
        DiffusionProbe probe;
        probe.model = model;
        probe.count = n;
        probe.direct = 1;
        std::vector<float> albedos(4 * n);
        for (std::size_t i = 0; i < n; ++i) albedos[4 * i] = float(i) / (n - 1);
        const std::vector<float> found = run_diffusion("probe_lobes", probe, 4, albedos);
        double before = -1;
        for (std::size_t i = 0; i < n; ++i) {
            const double sum = found[4 * i + 1] + found[4 * i + 2];
            EXPECT_FLOAT_EQ(found[4 * i], albedos[4 * i]);
            EXPECT_LE(sum, 1 + 1e-6);
            EXPECT_GE(sum, before - 1e-6);
            before = sum;
        }
        EXPECT_NEAR(before, 1, 1e-6);
    }
}

/// On a ball the area within a distance d of a point is pi d^2, as on a plane: the light between two distances is
/// known.
void check_ball(const Case &c, const char *what) {
    constexpr std::size_t bins = 8;
    DiffusionProbe probe = c.probe;
    probe.count = 1 << 18;
    std::array<double, 3> scale; // sigma_t' of the channels
    const float sigmas[3] = {probe.sigma.x, probe.sigma.y, probe.sigma.z};
    for (std::size_t k = 0; k < 3; ++k) scale[k] = sigmas[k] * (1 - double(probe.albedo) * probe.g);
    const std::vector<float> found = run_diffusion("probe_ball", probe, 8);
    double largest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        std::array<double, bins> sum{}, squares{};
        const auto bin = [&](double d) { return std::min(bins - 1, std::size_t(d / (2 * double(probe.ball)) * bins)); };
        for (std::size_t i = 0; i < probe.count; ++i) {
            const float *a = &found[8 * i], *b = a + 4;
            for (const float *f : {a, b}) {
                if (f[3] == 0) continue;
                sum[bin(f[3])] += f[k];
                squares[bin(f[3])] += f[k] * f[k];
                largest = std::max(largest, double(f[k]));
            }
        }
        for (std::size_t j = 0; j < bins; ++j) {
            const auto within = [&](std::size_t edge) {
                return c.exact.within(2 * double(probe.ball) * double(edge) / bins * scale[k]) / c.exact.total();
            };
            const double mean = sum[j] / probe.count, error = std::sqrt(squares[j]) / probe.count;
            // Two crossings of one line in a bin make the error larger, at most by sqrt(2).
            EXPECT_NEAR(mean, within(j + 1) - within(j), 4 * std::sqrt(2.0) * error + 1e-6)
                << what << ", " << c.exact.name() << ", channel " << k << ", bin " << j;
        }
    }
    // Profiles fall with the distance, so a weight is at most 1 / sum of axis chance x cosine, over the channel's
    // chance.
    EXPECT_LE(largest, 4 * 5 / .2) << what << ", " << c.exact.name();
}

TEST(DiffusionProbe, LinesFindTheLightOfABall) {
    for (Case c : cases()) {
        if (c.exact.total() == 0 || c.probe.g < 0 || (c.probe.g > 0) != (c.probe.albedo == .9f)) continue;
        for (const float ball : {.3f, 2.f, 20.f}) {
            c.probe.ball = ball;
            c.probe.sigma.y = 1.7f * c.probe.sigma.x;
            c.probe.sigma.z = 4 * c.probe.sigma.x;
            c.probe.chance = {.5f, .3f, .2f, 0};
            check_ball(c, fmt::format("ball {}", ball).c_str());
        }
    }
}

} // namespace
} // namespace nacre::test
