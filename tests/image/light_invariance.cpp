// What must not matter: how bright, how large and where a scene is, and how its light is divided into lights.
#include "image/light_scene.h"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace nacre {
namespace {

using namespace shared;

std::vector<scene::Light> all_kinds() {
    return {rect_light({.3, 1, .2}, {1, 0, 0}, {0, 0, 1}, {3, 2, 1}),
            rect_light({-.8, .4, 0}, {0, .5, .2}, {0, 0, .7}, {1, 2, 3}),
            point_light({.5, .7, -.5}, {.2, .1, .3}),
            directional_light({.3, -1, .2}, {.5, .6, .7}),
            constant_sky({.1, .2, .3}),
            image_sky(32, 16, [](const Vec3 &d) -> Vec3 { return Vec3(1 + d.x(), 1 + d.y(), 1 + d.z()); })};
}

// Radiance is in units of the scene's own light: 1e20 does not overflow, 1e-20 is not lost, and no sample changes.
TEST(LightInvariance, Brightness) {
    scene::Scene scene = floor_scene();
    scene.lights = all_kinds();
    add_emitter(scene, quad({.5, .2, -.2}, {0, 0, .3}, {0, .3, 0}), {1, 1, 1});
    const std::vector<Shot> reference = shoot_all(scene, 16);
    for (const double scale : {1e20, 1e-20}) {
        scene::Scene scaled = scene;
        for (scene::Light &light : scaled.lights) light.radiance *= scale;
        scaled.materials[1][PARAMETER_emission_luminance].value *= scale;
        const std::vector<Shot> shots = shoot_all(scaled, 16);
        for (std::size_t i = 0; i < shots.size(); ++i)
            ASSERT_LE((shots[i].mean / scale - reference[i].mean).norm(), 1e-5 * reference[i].mean.norm()) << scale;
    }
}

TEST(LightInvariance, LightsAddUp) {
    scene::Scene scene = floor_scene(.8);
    scene.lights = all_kinds();
    const Shot together = shoot(scene, 512);
    Shot sum;
    for (const scene::Light &light : all_kinds()) {
        scene.lights = {light};
        const Shot alone = shoot(scene, 256);
        sum.mean += alone.mean;
        sum.error = (sum.error.cwiseAbs2() + alone.error.cwiseAbs2()).cwiseSqrt();
    }
    EXPECT_GT(sum.mean.minCoeff(), .1);
    expect_same(together, sum, 1e-2, "six lights");
}

// One rect, or the hundred parts of it.
TEST(LightInvariance, ManyLights) {
    scene::Scene scene = floor_scene();
    for (int i = 0; i < 10; ++i)
        for (int j = 0; j < 10; ++j)
            scene.lights.push_back(
                rect_light({-.5 + (i + .5) / 10, .6, -.5 + (j + .5) / 10}, {.1, 0, 0}, {0, 0, .1}, {3, 2, 1}));
    expect_shot(shoot(scene, 256), Vec3(3, 2, 1) * (rect_irradiance(1, 1, .6) / 3.14159265358979), 6e-3, 1e-5, "parts");
}

/// A ball with subsurface scattering in a lop-sided light, in the frame x -> scale x + offset.
scene::Scene ball(double scale, const Vec3 &offset) {
    scene::Scene scene;
    scene::Material wax;
    wax[PARAMETER_specular_weight].value = Vec3::Zero();
    wax[PARAMETER_subsurface_weight].value = Vec3::Ones();
    wax[PARAMETER_subsurface_color].value = {.8, .5, .3};
    wax[PARAMETER_subsurface_radius].value = Vec3::Constant(.2 * scale);
    scene.materials = {wax};
    scene.objects = {{"ball", scene::make_sphere(offset, scale, 32), 0, 0}};
    scene.lights = {rect_light(offset + scale * Vec3(0, 2, 0), scale * Vec3(1, 0, 0), scale * Vec3(0, 0, 1), {9, 9, 9}),
                    point_light(offset + scale * Vec3(2, 0, 1), Vec3(9, 9, 9) * (scale * scale))};
    scene.camera.kind = CAMERA_ORTHOGRAPHIC;
    scene.camera.position = offset + scale * Vec3(1, 1, 3);
    scene.camera.target = offset + scale * Vec3(.2, .3, 0);
    scene.camera.height = .2 * scale;
    scene.image.width = scene.image.height = 16;
    return scene;
}

TEST(LightInvariance, PlaceAndScale) {
    const Shot reference = shoot(ball(1, {0, 0, 0}), 64);
    for (const double scale : {1e-3, 1., 1e3})
        for (const double offset : {0., 1e5}) {
            scene::Scene scene = ball(scale, Vec3(1, -2, .5) * offset * scale);
            scene.render.seed = 7; // not the same samples: only their mean is the same
            expect_same(shoot(scene, 64), reference, 3e-2, "scale " + std::to_string(scale));
        }
}

// Facing a directional light, amid a scene 1e11 times as large: squares of its triangles' areas are no floats.
TEST(LightInvariance, TinyTriangles) {
    constexpr double edge = 2e-11;
    scene::Scene scene = floor_scene(.5);
    scene.objects[0].mesh = quad({-edge / 2, 0, edge / 2}, {edge, 0, 0}, {0, 0, -edge});
    for (const double x : {-1., 1.}) scene.objects.push_back({"wall", quad({x, -1, -1}, {0, 2, 0}, {0, 0, 2}), 0, 0});
    scene.lights = {directional_light({0, -1, 0}, Vec3::Constant(std::numbers::pi))}; // along the walls
    scene.camera.position = {1e-9, 1e-9, 0};
    scene.camera.height = 1e-13;
    expect_shot(shoot(scene, 1), {.5, .5, .5}, 1e-5, 1e-5, "tiny");
}

} // namespace
} // namespace nacre
