// The specular layer over a diffuse base, in white light: nothing is lost and nothing is made.
#include "image/light_scene.h"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace nacre {
namespace {

using namespace shared;

scene::Scene furnace(double roughness, double ior, double weight, double metalness, const Vec3 &towards) {
    scene::Scene scene = floor_scene();
    scene::Material &material = scene.materials[0];
    material[PARAMETER_specular_weight].value = Vec3::Constant(weight);
    material[PARAMETER_specular_roughness].value = Vec3::Constant(roughness);
    material[PARAMETER_specular_ior].value = Vec3::Constant(ior);
    material[PARAMETER_base_metalness].value = Vec3::Constant(metalness);
    scene.lights = {constant_sky({1, 1, 1})};
    scene.camera.position = 3 * towards.normalized();
    return scene;
}

const Vec3 steep(.1, 1, 0), slanted(1, 1, .3), grazing(1, .03, 0);

// Reflection or base, both are drawn with weight 1: not only the mean, every sample is white.
TEST(BsdfFurnace, DielectricOverWhite) {
    for (const double roughness : {0., .1, .3, .6, 1.})
        for (const double ior : {1.01, 1.5, 3.})
            for (const Vec3 &towards : {steep, slanted, grazing})
                expect_shot(shoot(furnace(roughness, ior, roughness < .2 ? .5 : 1, 0, towards), 4), {1, 1, 1}, 1e-5,
                            1e-5, "roughness " + std::to_string(roughness) + " ior " + std::to_string(ior));
}

/// Share of a white metal's light that leaves after one reflection: GGX with height-correlated shadowing (Walter et al.
/// 2007, Heitz 2014), integrated over the slopes of its microfacets, s = rho^2 / (1 + rho^2), rho = tan / alpha.
double reflected_once(Vec3 towards, double alpha) {
    const Vec3 v = Vec3(towards.x(), towards.z(), towards.y()).normalized(); // z up
    const auto lambda = [&](const Vec3 &w) {
        return (std::sqrt(1 + alpha * alpha * (1 / (w.z() * w.z()) - 1)) - 1) / 2;
    };
    constexpr int n = 512;
    double sum = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double q = 1 - (i + .5) / n, s = 1 - q * q, t = 2 * std::numbers::pi * (j + .5) / n,
                         tangent = alpha * std::sqrt(s / (1 - s));
            const Vec3 h = Vec3(tangent * std::cos(t), tangent * std::sin(t), 1).normalized(), l = 2 * v.dot(h) * h - v;
            // Slopes are distributed evenly in s: D dh = ds / cos; the light's direction goes 4 v.h times as fast as h.
            // q = sqrt(1 - s) takes the square root out of the tail, ds = 2 q dq.
            if (l.z() > 0 && v.dot(h) > 0)
                sum += 2 * q * v.dot(h) / (h.z() * v.z() * (1 + lambda(v) + lambda(l))) / (n * n);
        }
    return sum;
}

// Metal reflects once: what its microfacets would send on to one another is missing, and nothing else.
TEST(BsdfFurnace, WhiteMetalLosesOnlyWhatIsReflectedTwice) {
    for (const Vec3 &towards : {steep, slanted, grazing})
        for (const double roughness : {0., .3, .6, 1.}) {
            const double exact = reflected_once(towards, std::max(roughness * roughness, 1e-3));
            EXPECT_LE(exact, 1 + 1e-6);
            expect_shot(shoot(furnace(roughness, 1.5, 1, 1, towards), 256), Vec3::Constant(exact), 1e-2, 1e-3,
                        "roughness " + std::to_string(roughness));
        }
}

// The same light, drawn as well as found: an image that is white everywhere.
TEST(BsdfFurnace, WhiteImageIsAWhiteSky) {
    for (const double roughness : {.1, .5})
        for (const Vec3 &towards : {slanted, grazing}) {
            scene::Scene scene = furnace(roughness, 1.5, 1, 0, towards);
            scene.lights = {image_sky(32, 16, [](const Vec3 &) -> Vec3 { return {1, 1, 1}; })};
            expect_shot(shoot(scene, 256), {1, 1, 1}, 5e-3, 1e-5, "roughness " + std::to_string(roughness));
        }
}

} // namespace
} // namespace nacre
