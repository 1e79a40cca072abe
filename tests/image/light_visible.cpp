// What the camera sees of lights, and alpha.
#include "image/light_scene.h"
#include <gtest/gtest.h>

namespace nacre {
namespace {

/// A camera that looks past the floor at the light or the sky behind.
scene::Scene scene_beside_floor() {
    scene::Scene scene = floor_scene();
    scene.camera.position = {5, 3, 0};
    scene.camera.target = {5, 3, -1};
    return scene;
}

TEST(LightVisible, Sky) {
    for (const bool visible : {true, false}) {
        scene::Scene scene = scene_beside_floor();
        scene.lights = {constant_sky({3, 2, 1})};
        scene.lights[0].visible = visible;
        const Shot shot = shoot(scene, 4);
        expect_shot(shot, visible ? Vec3(3, 2, 1) : Vec3(0, 0, 0), 0, 1e-6, "sky");
        EXPECT_EQ(shot.alpha, 0);
        scene.camera = floor_scene().camera; // it lights the floor all the same
        const Shot lit = shoot(scene, 4);
        expect_shot(lit, {3, 2, 1}, 1e-6, 1e-6, "floor");
        EXPECT_EQ(lit.alpha, 1);
    }
}

TEST(LightVisible, Rect) {
    for (const bool visible : {true, false}) {
        scene::Scene scene = scene_beside_floor();
        scene.lights = {rect_light({5, 3, -4}, {1, 0, 0}, {0, 1, 0}, {3, 2, 1})}; // faces +z: the camera
        scene.lights[0].visible = visible;
        expect_shot(shoot(scene, 4), visible ? Vec3(3, 2, 1) : Vec3(0, 0, 0), 0, 1e-6, "rect");
        EXPECT_EQ(shoot(scene, 4).alpha, 0);
        scene.lights[0].position.x() = 5.6; // just past its edge
        expect_shot(shoot(scene, 4), {0, 0, 0}, 0, 0, "beside the rect");
        scene.lights[0].position.x() = 5;
        std::swap(scene.lights[0].u, scene.lights[0].v); // its dark side
        expect_shot(shoot(scene, 4), {0, 0, 0}, 0, 0, "behind the rect");
    }
}

// Lights are no objects: a rect between camera and floor hides nothing.
TEST(LightVisible, RectsBlockNothing) {
    scene::Scene scene = floor_scene();
    scene.lights = {constant_sky({1, 1, 1}), rect_light({1.5, .5, 0}, {0, 1, 0}, {0, 0, 1}, {5, 5, 5})};
    scene.lights[1].visible = true;
    if (scene.lights[1].u.cross(scene.lights[1].v).x() > 0) std::swap(scene.lights[1].u, scene.lights[1].v);
    // Its dark side faces the camera, and the sky lights the floor through it.
    scene.lights[1].radiance = {0, 0, 0};
    expect_shot(shoot(scene, 4), {1, 1, 1}, 1e-6, 1e-6, "through the rect");
}

TEST(LightVisible, MeshThatEmits) {
    scene::Scene scene = scene_beside_floor();
    add_emitter(scene, quad({4, 2, -4}, {2, 0, 0}, {0, 2, 0}), {3, 2, 1});
    Shot shot = shoot(scene, 4);
    expect_shot(shot, {3, 2, 1}, 0, 1e-6, "emitter");
    EXPECT_EQ(shot.alpha, 1);
    scene.camera.position.z() = -8;
    shot = shoot(scene, 4);
    expect_shot(shot, {0, 0, 0}, 0, 0, "behind the emitter");
    EXPECT_EQ(shot.alpha, 1);
}

// A pixel that geometry covers by a half: alpha is a half, and colours are not divided by it.
TEST(LightVisible, AlphaIsCoverage) {
    scene::Scene scene = floor_scene();
    scene.lights = {constant_sky({1, 1, 1})};
    scene.lights[0].visible = false;
    scene.camera.position = {-.9, 2, 0}; // above the floor's edge
    scene.camera.target = {-.9, 0, 0};
    scene.camera.up = {0, 0, 1};
    scene.camera.height = .1;
    scene.image.width = 1;
    const std::vector<Shot> pixels = shoot_all(scene, 256);
    for (const Shot &pixel : pixels) {
        EXPECT_NEAR(pixel.alpha, .5, 1e-6 + 1. / 256); // the samples are stratified
        EXPECT_NEAR(pixel.mean.x(), pixel.alpha, 1e-5);
    }
}

} // namespace
} // namespace nacre
