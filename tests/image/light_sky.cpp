// Environment images: where their texels are in the world, how they turn, and what they light.
#include "image/light_scene.h"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace nacre {
namespace {

using std::numbers::pi;

/// Black but for one texel.
scene::Light sun(std::uint32_t width, std::uint32_t height, std::uint32_t x, std::uint32_t y, const Vec3 &radiance) {
    scene::Light light = image_sky(width, height, [](const Vec3 &) -> Vec3 { return {0, 0, 0}; });
    for (int c = 0; c < 3; ++c) light.pixels[3 * (y * width + x) + std::size_t(c)] = float(radiance[c]);
    return light;
}

/// Irradiance of the bilinear picture of a one-texel sun on a floor that faces +y, by quadrature over its 2 x 2 texels.
double sun_irradiance(std::uint32_t width, std::uint32_t height, std::uint32_t y) {
    constexpr int n = 1000;
    double sum = 0;
    for (int j = 0; j < n; ++j) {
        const double t = 2 * (j + .5) / n - 1, polar = pi * (y + .5 + t) / height;
        sum += (1 - std::abs(t)) * std::max(0.0, std::cos(polar)) * std::sin(polar) * 2 * pi / height / n;
    }
    return sum * 2 * pi / width; // over the azimuth the tent's integral is one texel
}

TEST(LightImage, OneTexelSun) {
    for (const std::uint32_t y : {2u, 20u}) {
        scene::Scene scene = floor_scene(.7);
        scene.lights = {sun(128, 64, 33, y, {3e4, 2e4, 1e4})};
        const Vec3 exact = Vec3(3e4, 2e4, 1e4) * (.7 / pi * sun_irradiance(128, 64, y));
        expect_shot(shoot(scene, 512), exact, 8e-3, 1e-5, "sun in row " + std::to_string(y));
    }
}

// Turning the picture turns the light: a floor that faces up does not notice, a wall does.
TEST(LightImage, RotateIsCounterClockwiseAboutY) {
    const auto lopsided = [](const Vec3 &d) -> Vec3 {
        return {1 + d.x(), 1 + d.z(), std::max(0.0, 1 + .5 * d.x() - d.y())};
    };
    scene::Scene flat = floor_scene();
    flat.lights = {image_sky(64, 32, lopsided)};
    const Shot straight = shoot(flat, 256);
    flat.lights[0].rotate = 110;
    expect_same(shoot(flat, 256), straight, 6e-3, "floor");

    // A wall that faces +x. Light 1 + d.w gives it pi + 2 pi / 3 w.x, and w turns with the picture: about y, x goes to
    // -z.
    scene::Scene wall = floor_scene();
    wall.objects[0].mesh = quad({0, -1, .9}, {0, 0, -2}, {0, 2, 0});
    wall.camera.position = {3, .3, .1};
    for (const double degrees : {0., 90., 200.}) {
        wall.lights = {image_sky(256, 128, lopsided)};
        wall.lights[0].rotate = degrees;
        const double turn = degrees * pi / 180;
        const Vec3 x(std::cos(turn), 0, -std::sin(turn)), z(std::sin(turn), 0, std::cos(turn));
        Shot shot = shoot(wall, 256);
        shot.mean.z() = 1; // the blue is for the floor: no closed form here
        shot.error.z() = 0;
        expect_shot(shot, {1 + 2. / 3 * x.x(), 1 + 2. / 3 * z.x(), 1}, 6e-3, 3e-4,
                    "turned by " + std::to_string(degrees));
    }
}

// The camera sees texels where the documentation says: u = 1/2 + atan2(z, x) / 2 pi, row 0 at +y.
TEST(LightImage, TexelsAreWhereTheyShouldBe) {
    for (const std::uint32_t x : {0u, 5u, 12u})
        for (const std::uint32_t y : {1u, 4u, 6u}) {
            scene::Scene scene = floor_scene();
            scene.objects[0].mesh = quad({-.9, -50, 1}, {2, 0, 0}, {0, 0, -2});
            scene.lights = {sun(16, 8, x, y, {3, 2, 1})};
            const double azimuth = 2 * pi * ((x + .5) / 16 - .5), polar = pi * (y + .5) / 8;
            const Vec3 d(std::sin(polar) * std::cos(azimuth), std::cos(polar), std::sin(polar) * std::sin(azimuth));
            scene.camera.position = {7, 8, 9};
            scene.camera.target = scene.camera.position + d;
            expect_shot(shoot(scene, 1), {3, 2, 1}, 1e-4, 1e-4, "centre of the texel");
            // Half-way to the next row it is half as bright.
            const double lower = pi * (y + 1.) / 8;
            scene.camera.target = scene.camera.position + Vec3(std::sin(lower) * std::cos(azimuth), std::cos(lower),
                                                               std::sin(lower) * std::sin(azimuth));
            expect_shot(shoot(scene, 1), {1.5, 1, .5}, 1e-4, 1e-4, "edge of the texel");
        }
}

} // namespace
} // namespace nacre
