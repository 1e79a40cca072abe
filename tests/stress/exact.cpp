// Media at the ends of their ranges against values known without random numbers.
#include "device/probe.h"
#include "image/rendered.h"
#include "scene/normalise.h"
#include "stress/bodies.h"
#include "stress/tally.h"
#include <cmath>
#include <gtest/gtest.h>

namespace nacre::stress {
namespace {

using namespace shared;

constexpr double bleeds[] = {0, 1e-7, 1e-3, .5, 1, 10, 1e4};

/// R = (1-r)/(1+r), r = sqrt(1-albedo): half-space, isotropic, entry over the hemisphere, any renewal law, and any
/// extinction of the channels.
void check_universal(Guiding guiding, const std::vector<std::array<double, 3>> &albedos, const Vec3 &sigma,
                     std::uint32_t walks, Tally &tally) {
    for (const double bleed : {0., 1e-7, 1e-3, .5, 1., 2., 4.}) // beyond, flights are longer than a float can say
        for (const auto &albedo : albedos) {
            test::Probe probe;
            probe.entry = ENTRY_UNIFORM;
            probe.bleed = float(bleed);
            probe.sigma = {float(sigma.x()), float(sigma.y()), float(sigma.z()), 0};
            probe.albedo = {float(albedo[0]), float(albedo[1]), float(albedo[2]), 0};
            const test::Walks found = test::run_walks(probe, walks, CHANNEL_HERO, guiding);
            for (std::size_t c = 0; c < 3; ++c) {
                const double r = std::sqrt(1 - double(float(albedo[c]))), exact = (1 - r) / (1 + r);
                const test::Estimate &seen = found.near[c];
                tally.add({{"albedo", albedo[c]},
                           {"bleed", bleed},
                           {"ratio", sigma[Eigen::Index(c)]},
                           {"guided", guiding == GUIDING_EIGEN}},
                          std::abs(seen.mean - exact) <= 4 * seen.error + 1e-5,
                          fmt::format("found {:.6g} +- {:.2g}, exact {:.6g}", seen.mean, seen.error, exact));
            }
        }
}

void check_half_spaces(std::uint32_t walks) {
    Tally tally("Half-space, exact");
    for (const Guiding guiding : {GUIDING_NONE, GUIDING_EIGEN}) {
        check_universal(guiding, {{0, 1e-6, .1}, {.5, .9, .99}}, {1, 1, 1}, walks, tally);
        check_universal(guiding, {{1 - 1e-4, 1 - 1e-5, 1 - 1e-6}}, {1, 1, 1}, walks / 8, tally);
        check_universal(guiding, {{.1, .5, .9}, {.9, .5, .1}}, {1, 1e3, 1e6}, walks, tally);
        check_universal(guiding, {{.9, .9, .9}}, {1, 1e-3, 1e-6}, walks, tally);
    }
    tally.expect_all();
}

TEST(Exact, HalfSpaceOfAnyAlbedoBleedAndColour) { check_half_spaces(1 << 13); }
TEST(LongExact, HalfSpaceOfAnyAlbedoBleedAndColour) { check_half_spaces(1 << 20); }

/// Share of diffuse light that passes a slab of optical depth tau without a scatter.
double unscattered(double tau, double bleed) {
    constexpr int steps = 20000;
    double sum = 0;
    for (int i = 0; i < steps; ++i) { // over mu^2, whose density is 1
        const double depth = tau / std::sqrt((i + .5) / steps);
        sum += bleed > 0 ? std::exp(-std::log1p(bleed * depth) / bleed) : std::exp(-depth);
    }
    return sum / steps;
}

/// A slab without scattering, of thickness .2 and a hundred times as wide.
scene::Scene black_slab(double free_path, double bleed, FlightLaw flight) {
    const Body body{.g = .5,
                    .bleed = bleed,
                    .albedo = Vec3::Zero(),
                    .free_path = .2 * free_path,
                    .scale = {1, .1, 1e-3},
                    .flight = flight};
    scene::Scene scene;
    scene.materials = {material_of(body)};
    scene.objects = {{"slab", scene::make_box({-10, -10, -.2}, {10, 10, 0}), 0, 0}};
    scene.lights.emplace_back();
    scene.lights.back().visible = true;
    scene.camera.kind = CAMERA_ORTHOGRAPHIC;
    scene.camera.height = .1;
    scene.image = {32, 32};
    scene.render.spp = 16;
    scene.render.guiding = GUIDING_NONE;
    scene.render.clearance = false;
    return scene;
}

void check_slabs(const std::vector<double> &free_paths) {
    Tally tally("Black slab, exact");
    constexpr double unseen = 10 / (32. * 32 * 16); // what is so rare may not be among the samples
    for (const double free_path : free_paths)
        for (const double bleed : bleeds)
            for (const FlightLaw flight : {FLIGHT_RENEWAL, FLIGHT_RECIPROCAL}) {
                const scene::Scene scene = black_slab(free_path, bleed, flight);
                const double shortest = 1e-7 * scene::frame_of(scene).size / .2; // walk/medium.h has none below
                const Seen whole = seen(rendered(scene, with_variance()).picture, 0, 0, 32, 32);
                for (int c = 0; c < 3; ++c) {
                    const double path = free_path * scene.materials[0][PARAMETER_subsurface_radius_scale].value[c];
                    const double exact = unscattered(1 / std::max(path, shortest), bleed);
                    tally.add(
                        {{"free path", free_path}, {"bleed", bleed}, {"channel", c}, {"reciprocal", flight}},
                        whole.finite && std::abs(whole.mean[c] - exact) <= 4 * whole.error[c] + unseen,
                        fmt::format("found {:.6g} +- {:.2g}, exact {:.6g}", whole.mean[c], whole.error[c], exact));
                }
            }
    tally.expect_all();
}

TEST(Exact, BlackSlabOfAnyDepth) { check_slabs({1e-6, 1e-2, 1, 1e3}); }
TEST(LongExact, BlackSlabOfAnyDepth) {
    std::vector<double> free_paths;
    for (int e = -12; e <= 12; ++e) free_paths.push_back(std::pow(10, .5 * e));
    check_slabs(free_paths);
}

} // namespace
} // namespace nacre::stress
