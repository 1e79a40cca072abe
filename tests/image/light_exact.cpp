// Lights on a diffuse floor, where the radiance is known: albedo / pi times the irradiance.
#include "image/light_scene.h"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace nacre {
namespace {

using namespace shared;
using std::numbers::pi;

// No random number matters: the samples are equal.
TEST(LightPoint, InverseSquareAndCosine) {
    for (const Vec3 &position : {Vec3(0, 2, 0), Vec3(.5, 1, -.7), Vec3(0, 100, 50), Vec3(.01, .05, 0)}) {
        scene::Scene scene = floor_scene(.5);
        const Vec3 intensity(3, 2, 1);
        scene.lights = {point_light(position, intensity)};
        const Shot shot = shoot(scene, 4);
        const double cosine = position.y() / position.norm();
        expect_shot(shot, intensity * (.5 / pi * cosine / position.squaredNorm()), 1e-5, 2e-4, "point");
    }
}

TEST(LightDirectional, Cosine) {
    for (const Vec3 &towards : {Vec3(0, 1, 0), Vec3(1, 2, -3), Vec3(.99, .01, 0)}) {
        scene::Scene scene = floor_scene(.8);
        scene.lights = {directional_light(-towards, {3, 2, 1})};
        const double cosine = towards.normalized().y();
        expect_shot(shoot(scene, 4), Vec3(3, 2, 1) * (.8 / pi * cosine), 1e-6, 1e-5, "directional");
    }
}

// A light below the floor, and one behind a lid, do not light it.
TEST(LightDelta, IsShadowed) {
    scene::Scene scene = floor_scene();
    scene.lights = {point_light({0, -1, 0}, {1, 1, 1}), directional_light({0, 1, 0}, {1, 1, 1})};
    EXPECT_EQ(shoot(scene, 4).mean, Vec3(0, 0, 0));
    scene.lights = {point_light({0, 1, 0}, {1, 1, 1}), directional_light({0, -1, 0}, {1, 1, 1})};
    EXPECT_GT(shoot(scene, 4).mean.x(), .1);
    scene.objects.push_back({"lid", quad({-.1, .5, -.1}, {.2, 0, 0}, {0, 0, .2}), 0, 0});
    scene.render.max_depth = 1; // direct light alone: the lid reflects what the floor around it gets
    EXPECT_EQ(shoot(scene, 64).mean, Vec3(0, 0, 0));
}

TEST(LightRect, FormFactor) {
    for (const double height : {.02, .3, 1.0, 20.0}) {
        scene::Scene scene = floor_scene(.7);
        const Vec3 radiance(3, 2, 1);
        scene.lights = {rect_light({0, height, 0}, {.8, 0, 0}, {0, 0, 1.5}, radiance)};
        const double irradiance = rect_irradiance(.8, 1.5, height);
        expect_shot(shoot(scene, 256), radiance * (.7 / pi * irradiance), 4e-3, 1e-5,
                    "height " + std::to_string(height));
    }
}

// Each lamp's points are as even as those of one alone, where an edge hides some of them. With points that are a random
// choice from even ones the errors are 1.4, 1.4 and 3.7 times as large.
TEST(LightRect, SeveralBehindAnEdgeAreAsEvenAsOne) {
    scene::Scene scene = floor_scene(1);
    scene.objects.push_back({"lid", quad({0, .5, -1}, {1, 0, 0}, {0, 0, 2}), 0, 0});
    scene.render.max_depth = 1;
    Vec3 exact(0, 0, 0);
    for (const auto &[height, radiance] :
         {std::pair{1.5, Vec3(1, .5, .1)}, {2.5, Vec3(2, 3, 5)}, {4., Vec3(4, 4, 4)}}) {
        scene.lights.push_back(rect_light({0, height, 0}, {.9, 0, 0}, {0, 0, .9}, radiance));
        exact += radiance * (.5 * rect_irradiance(.9, .9, height) / pi);
    }
    expect_shot(shoot(scene, 256), exact, 1.9e-3, 1e-5, "three rects");
}

// It emits towards u x v only.
TEST(LightRect, OneSided) {
    scene::Scene scene = floor_scene();
    scene.lights = {rect_light({0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 1})};
    EXPECT_EQ(shoot(scene, 64).mean, Vec3(0, 0, 0));
}

// What carries radiance does not matter: a rect, and a mesh in the same place that emits.
TEST(LightMesh, AQuadIsARect) {
    scene::Scene scene = floor_scene();
    scene.render.max_depth = 1; // the mesh, unlike the rect, is seen by what the floor reflects: black, but there
    add_emitter(scene, quad({-.5, .6, -.5}, {1, 0, 0}, {0, 0, 1}), {3, 2, 1});
    expect_shot(shoot(scene, 256), Vec3(3, 2, 1) * (rect_irradiance(1, 1, .6) / pi), 4e-3, 1e-5, "quad");
}

// A sphere wholly above the horizon: pi L (r / h)^2 below its centre. That of 256 segments lies inside by 1e-4 or less.
TEST(LightMesh, Sphere) {
    scene::Scene scene = floor_scene();
    add_emitter(scene, scene::make_sphere({0, .8, 0}, .5, 256), {3, 2, 1});
    scene.camera.position = {3, .3, 0}; // past the sphere
    const double exact = std::pow(.5 / .8, 2);
    expect_shot(shoot(scene, 256), Vec3(3, 2, 1) * exact, 1e-2, 3e-4, "sphere");
}

TEST(LightSky, Constant) {
    scene::Scene scene = floor_scene(.6);
    scene.lights = {constant_sky({3, 2, 1})};
    // Every direction of the floor's hemisphere sees it: no variance.
    expect_shot(shoot(scene, 4), Vec3(3, 2, 1) * .6, 1e-6, 1e-6, "constant");
}

// Radiance max(0, y): irradiance 2 pi / 3. The bilinear picture of it differs by its texels' size squared.
TEST(LightSky, AnImageThatIsAnalytic) {
    scene::Scene scene = floor_scene();
    scene.lights = {image_sky(512, 256, [](const Vec3 &d) -> Vec3 { return Vec3(3, 2, 1) * std::max(0.0, d.y()); })};
    expect_shot(shoot(scene, 256), Vec3(3, 2, 1) * (2.0 / 3), 4e-3, 1e-4, "sky");
}

} // namespace
} // namespace nacre
