// Reflections whose colour is known: Fresnel at smooth surfaces, and mirrors that show what stands opposite.
#include "image/light_scene.h"
#include <cmath>
#include <gtest/gtest.h>

namespace nacre {
namespace {

using namespace shared;

scene::Scene shiny_floor(double roughness) {
    scene::Scene scene = floor_scene();
    scene.materials[0][PARAMETER_base_color].value = Vec3::Zero();
    scene.materials[0][PARAMETER_specular_weight].value = Vec3::Ones();
    scene.materials[0][PARAMETER_specular_roughness].value = Vec3::Constant(roughness);
    scene.lights = {constant_sky({1, 1, 1})};
    return scene;
}

double fresnel(double cosine, double ior) {
    const double inner = std::sqrt(1 - (1 - cosine * cosine) / (ior * ior));
    const double p = (ior * cosine - inner) / (ior * cosine + inner),
                 s = (cosine - ior * inner) / (cosine + ior * inner);
    return (p * p + s * s) / 2;
}

// A polished black dielectric in a white sky shows its Fresnel reflectance; specular_weight scales that at normal
// incidence.
TEST(BsdfFresnel, Dielectric) {
    for (const double ior : {1.3, 1.5, 2.5})
        for (const double height : {1000., 1., .2})
            for (const double weight : {1., .25}) {
                scene::Scene scene = shiny_floor(0);
                scene.materials[0][PARAMETER_specular_ior].value = Vec3::Constant(ior);
                scene.materials[0][PARAMETER_specular_weight].value = Vec3::Constant(weight);
                scene.camera.position = Vec3(1, height, .2).normalized() * 3;
                const double f0 = std::sqrt(weight) * (ior - 1) / (ior + 1), scaled = (1 + f0) / (1 - f0);
                const double exact = fresnel(scene.camera.position.normalized().y(), scaled);
                expect_shot(shoot(scene, 1024), Vec3::Constant(exact), .03, 1e-2, "ior " + std::to_string(ior));
            }
}

// The highlights of a base that is dark in two channels are most of what shows there: they are drawn about as often as
// the base, so that samples lie no further from their mean than the mean itself. Drawn as often as they reflect (.04)
// they would.
TEST(BsdfFresnel, HighlightsOfDarkChannelsAreNotRare) {
    const Vec3 color(.9, .01, .02);
    scene::Scene scene = shiny_floor(0);
    scene.materials[0][PARAMETER_base_color].value = color;
    scene.materials[0][PARAMETER_specular_ior].value = Vec3::Constant(1.5);
    scene.camera.position = Vec3(1, 1000, 0).normalized() * 3;
    const double reflected = fresnel(1, 1.5);
    const Vec3 exact = Vec3::Constant(reflected) + (1 - reflected) * color;
    constexpr double samples = 64 * 64; // of 8 x 8 pixels
    expect_shot(shoot(scene, 64), exact, 1 / std::sqrt(samples), 1e-3, "red floor");
}

// A metal's colour at normal incidence is base_color; at grazing incidence it is white (Schlick).
TEST(BsdfFresnel, Metal) {
    const Vec3 color(.9, .5, .1);
    for (const double height : {1000., .5}) {
        scene::Scene scene = shiny_floor(0);
        scene.materials[0][PARAMETER_base_color].value = color;
        scene.materials[0][PARAMETER_base_metalness].value = Vec3::Ones();
        scene.camera.position = Vec3(1, height, 0).normalized() * 3;
        const double share = std::pow(1 - scene.camera.position.normalized().y(), 5);
        expect_shot(shoot(scene, 256), color + share * (Vec3(1, 1, 1) - color), 5e-3, 2e-3, "metal");
    }
}

// A mirror shows the picture of a wall upside down: four lit quadrants of known colours.
TEST(BsdfMirror, ShowsWhatIsOpposite) {
    scene::Scene scene = shiny_floor(0);
    scene.materials[0][PARAMETER_base_color].value = Vec3::Ones();
    scene.materials[0][PARAMETER_base_metalness].value = Vec3::Ones();
    scene.lights.clear();
    const Vec3 colors[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
    for (int i = 0; i < 4; ++i) // left or right in z, low or high in y; they face +x
        add_emitter(scene, quad({-2, i / 2 * 1., i % 2 ? -1. : 0.}, {0, 1, 0}, {0, 0, 1}), colors[i]);
    // From (3, y, z) over the origin to (-2, 2/3 y, -2/3 z).
    const struct {
        double y, z;
        int color;
    } views[] = {{1, -1, 0}, {1, 1, 1}, {2.4, -1, 2}, {2.4, 1, 3}};
    for (const auto &view : views) {
        scene.camera.position = {3, view.y, view.z};
        const Shot shot = shoot(scene, 16);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(shot.mean[c], colors[view.color][c], 1e-2) << "y " << view.y << " z " << view.z;
    }
}

// However rough, a layer lit by a drawn light and by a found one is the same: a rect and a mesh that emits.
TEST(BsdfMis, RoughReflectionOfARectAndOfAMesh) {
    for (const double roughness : {.15, .4, .8}) {
        scene::Scene scene = shiny_floor(roughness);
        scene.render.max_depth = 1;
        scene.lights = {rect_light({-1.5, .5, 0}, {0, 1, 0}, {0, 0, 1}, {3, 2, 1})};
        const Shot rect = shoot(scene, 512);
        scene.lights.clear();
        add_emitter(scene, quad({-1.5, 0, -.5}, {0, 1, 0}, {0, 0, 1}), {3, 2, 1});
        expect_same(shoot(scene, 512), rect, 2e-2, "roughness " + std::to_string(roughness));
    }
}

} // namespace
} // namespace nacre
