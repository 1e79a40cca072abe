// Light of any strength, pictures of any shape, any number of samples.
#include "image/rendered.h"
#include "stress/bodies.h"
#include "stress/tally.h"
#include <cmath>
#include <gtest/gtest.h>

namespace nacre::stress {
namespace {

using namespace shared;

/// A ball of wax with lights of every kind, all as strong as `strengths` says.
scene::Scene lit_ball(const std::array<double, 4> &strengths) {
    scene::Scene scene;
    scene.materials = {material_of({.g = .5, .bleed = .5, .albedo = {.99, .9, .5}})};
    scene.objects = {{"ball", scene::make_sphere({0, 0, 0}, 1, 32), 0, 0}};
    const LightKind kinds[] = {LIGHT_ENVIRONMENT, LIGHT_RECT, LIGHT_POINT, LIGHT_DIRECTIONAL};
    for (std::size_t i = 0; i < 4; ++i) {
        scene::Light &light = scene.lights.emplace_back();
        light.kind = kinds[i];
        light.position = i == 1 ? Vec3(0, 3, 0) : Vec3(2, 0, 3);
        light.u = Vec3::UnitX();
        light.v = Vec3::UnitZ();
        if (i == 1) std::swap(light.u, light.v), light.u *= -1; // down
        light.radiance = Vec3::Constant(strengths[i]);
    }
    scene.image = {24, 24};
    scene.render.spp = 16;
    scene.render.guiding = GUIDING_NONE;
    scene.render.clearance = false;
    return scene;
}

/// One kind of light a hundred orders of magnitude above or below what the others are: those do not count, or are all.
TEST(Pictures, LightOfAnyStrength) {
    Tally tally("Light");
    const auto look = [](const std::array<double, 4> &strengths) {
        return seen(rendered(lit_ball(strengths), with_variance()).picture, 0, 0, 24, 24);
    };
    for (std::size_t kind = 0; kind < 4; ++kind) {
        std::array<double, 4> strengths{};
        strengths[kind] = 1;
        const Seen one = look(strengths);
        for (const double strength : {1e-20, 1e-10, 1e10, 1e20})
            for (const double others : {0., 1e-20}) {
                strengths.fill(others * strength);
                strengths[kind] = strength;
                const Seen found = look(strengths);
                // Other lights, however weak, take their turn in being drawn: the samples differ.
                const Vec3 error = (found.error / strength).cwiseMax(one.error) * std::sqrt(2);
                tally.add({{"kind", double(kind)}, {"strength", strength}, {"others", others}},
                          found.finite && one.mean.minCoeff() > 0 &&
                              ((found.mean / strength - one.mean).cwiseAbs() - 4 * error).maxCoeff() <= 1e-6,
                          fmt::format("{}; at strength 1 {}", found.text(), one.text()));
            }
    }
    tally.expect_all();
}

scene::Scene white_ball(int width, int height, std::uint32_t spp) {
    scene::Scene scene;
    scene.materials = {material_of({.g = .5, .bleed = .5})};
    scene.objects = {{"ball", scene::make_sphere({0, 0, 0}, 1, 32), 0, 0}};
    scene.lights.emplace_back();
    scene.lights.back().visible = true;
    scene.camera.kind = CAMERA_ORTHOGRAPHIC;
    scene.camera.height = width > height ? 2.0 * height / width : 2.0;
    scene.image = {width, height};
    scene.render.spp = spp;
    scene.render.max_depth = 0;
    scene.render.guiding = GUIDING_NONE;
    scene.render.clearance = false;
    return scene;
}

void check_picture(Tally &tally, int width, int height, std::uint32_t spp) {
    const Rendered found = rendered(white_ball(width, height, spp), with_variance());
    const Seen whole = seen(found.picture, 0, 0, width, height);
    tally.add({{"width", width}, {"height", height}, {"samples", spp}},
              whole.is(Vec3::Ones(), 1e-5) && whole.largest <= 1 + 1e-4 &&
                  found.statistics.samples == std::uint64_t(width) * std::uint64_t(height) * spp &&
                  found.statistics[COUNTER_non_finite] == 0,
              whole.text());
}

TEST(Pictures, OfAnyShapeAndSamples) {
    Tally tally("Pictures");
    for (const auto &[width, height] : {std::pair{1, 1}, {16384, 1}, {1, 16384}, {4097, 3}})
        for (const std::uint32_t spp : {1u, 3u, 65u}) check_picture(tally, width, height, spp);
    tally.expect_all();
}

TEST(LongPictures, OfAnyShapeAndSamples) {
    Tally tally("Pictures");
    for (const std::uint32_t spp : {1000000u, 999983u}) check_picture(tally, 1, 1, spp);
    for (const auto &[width, height] : {std::pair{16384, 64}, {64, 16384}}) check_picture(tally, width, height, 4);
    tally.expect_all();
}

} // namespace
} // namespace nacre::stress
