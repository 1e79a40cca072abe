// Lights add up: all at once, where each point chooses among them, they show what they show one by one, where it does
// not.
#include "image/light_scene.h"
#include <gtest/gtest.h>

namespace nacre {
namespace {

using namespace shared;

Vec3 blue_above(const Vec3 &direction) { return direction.y() > 0 ? Vec3(.1, .2, .6) : Vec3(.4, .1, 0); }

void expect_sum(const scene::Scene &bare, const std::vector<scene::Light> &lights, std::uint32_t spp,
                double largest_error, const std::string &what) {
    scene::Scene all = bare;
    all.lights = lights;
    const Shot together = shoot(all, spp);
    Shot sum;
    Vec3 squares(0, 0, 0);
    for (const scene::Light &light : lights) {
        scene::Scene one = bare;
        one.lights = {light};
        one.render.seed = std::uint32_t(&light - lights.data()) + 7;
        const Shot shot = shoot(one, spp);
        sum.mean += shot.mean;
        squares += shot.error.cwiseAbs2();
    }
    sum.error = squares.cwiseSqrt();
    expect_same(together, sum, largest_error, what);
}

// Rects near and far, one that the floor cuts, so that part of it is below the horizon, one that faces away; lights
// that only the choice finds; an environment that the BSDF finds too. Diffuse, and under a rough and glossy layer,
// which sees lights by its own directions more than by theirs.
TEST(LightSum, FewLights) {
    const std::vector<scene::Light> lights = {
        rect_light({0, .3, 0}, {.4, 0, 0}, {0, 0, .4}, {2, 1, .5}),
        rect_light({-1.5, .2, 0}, {0, 0, 2}, {0, 1, 0}, {3, 4, 2}),
        rect_light({0, 3, -2}, {4, 0, 0}, {0, 1, 2}, {1, 1, 3}),
        rect_light({0, 2, 0}, {0, 0, 1}, {1, 0, 0}, {50, 50, 50}),
        point_light({.4, .2, -.3}, {.1, .2, .1}),
        directional_light({1, -.2, 0}, {1, .5, 2}),
        image_sky(8, 4, blue_above),
    };
    scene::Scene floor = floor_scene(.7);
    expect_sum(floor, lights, 256, .02, "diffuse");
    floor.materials[0][PARAMETER_specular_weight].value = Vec3::Ones();
    floor.materials[0][PARAMETER_specular_roughness].value = Vec3::Constant(.6);
    floor.materials[0][PARAMETER_specular_ior].value = Vec3::Constant(3);
    expect_sum(floor, lights, 256, .02, "under a rough layer");
}

// Walks leave as Lambertian vertices, and go on to other surfaces.
TEST(LightSum, FewLightsOnAMedium) {
    scene::Scene scene = floor_scene();
    scene.objects[0].mesh = scene::make_box({-.9, -2, -1}, {1.1, 0, 1});
    scene.materials[0][PARAMETER_subsurface_weight].value = Vec3::Ones();
    scene.materials[0][PARAMETER_subsurface_color].value = {.8, .5, .4};
    scene.materials[0][PARAMETER_subsurface_radius].value = Vec3::Constant(.02);
    expect_sum(scene,
               {rect_light({0, .5, 0}, {.4, 0, 0}, {0, 0, .4}, {2, 1, .5}),
                rect_light({-2, .2, 0}, {0, 0, 2}, {0, 1, 0}, {3, 4, 2}), point_light({.4, .2, -.3}, {.1, .2, .1})},
               128, .02, "walks");
}

} // namespace
} // namespace nacre
