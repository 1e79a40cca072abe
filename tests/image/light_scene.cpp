#include "image/light_scene.h"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace nacre {

using namespace shared;
using std::numbers::pi;

scene::Mesh quad(const Vec3 &a, const Vec3 &u, const Vec3 &v) {
    scene::Mesh mesh;
    mesh.positions = {a, a + u, a + u + v, a + v};
    mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

scene::Scene floor_scene(double rho) {
    scene::Scene scene;
    scene::Material material;
    material[PARAMETER_base_color].value = Vec3::Constant(rho);
    material[PARAMETER_specular_weight].value = Vec3::Zero();
    scene.materials = {material};
    scene.objects = {{"floor", quad({-.9, 0, 1}, {2, 0, 0}, {0, 0, -2}), 0, 0}};
    scene.camera.kind = CAMERA_ORTHOGRAPHIC;
    scene.camera.position = {3, 1, 0};
    scene.camera.height = 1e-6;
    scene.image.width = scene.image.height = 8;
    return scene;
}

scene::Light rect_light(const Vec3 &center, const Vec3 &u, const Vec3 &v, const Vec3 &radiance) {
    scene::Light light;
    light.kind = LIGHT_RECT;
    light.position = center;
    light.u = u;
    light.v = v;
    light.radiance = radiance;
    return light;
}

scene::Light point_light(const Vec3 &position, const Vec3 &intensity) {
    scene::Light light;
    light.kind = LIGHT_POINT;
    light.position = position;
    light.radiance = intensity;
    return light;
}

scene::Light directional_light(const Vec3 &direction, const Vec3 &irradiance) {
    scene::Light light;
    light.kind = LIGHT_DIRECTIONAL;
    light.direction = direction.normalized();
    light.radiance = irradiance;
    return light;
}

scene::Light constant_sky(const Vec3 &radiance) {
    scene::Light light;
    light.radiance = radiance;
    light.visible = true;
    return light;
}

scene::Light image_sky(std::uint32_t width, std::uint32_t height, Vec3 radiance(const Vec3 &)) {
    scene::Light light = constant_sky({1, 1, 1});
    light.kind = LIGHT_ENVIRONMENT_IMAGE;
    light.width = width;
    light.height = height;
    for (std::uint32_t j = 0; j < height; ++j)
        for (std::uint32_t i = 0; i < width; ++i) {
            const double azimuth = 2 * pi * ((i + .5) / width - .5), polar = pi * (j + .5) / height;
            const Vec3 color =
                radiance({std::sin(polar) * std::cos(azimuth), std::cos(polar), std::sin(polar) * std::sin(azimuth)});
            for (int c = 0; c < 3; ++c) light.pixels.push_back(float(color[c]));
        }
    return light;
}

void add_emitter(scene::Scene &scene, scene::Mesh mesh, const Vec3 &radiance) {
    scene::Material material;
    material[PARAMETER_base_color].value = Vec3::Zero();
    material[PARAMETER_specular_weight].value = Vec3::Zero();
    material[PARAMETER_emission_color].value = radiance;
    material[PARAMETER_emission_luminance].value = Vec3::Ones();
    scene.objects.push_back({"emitter", std::move(mesh), std::uint32_t(scene.materials.size()), 0});
    scene.materials.push_back(material);
}

std::vector<Shot> shoot_all(scene::Scene scene, std::uint32_t spp) {
    scene.render.spp = spp;
    const Rendered result = rendered(scene);
    EXPECT_EQ(result.statistics[COUNTER_non_finite], 0u);
    const std::vector<float> &pixels = result.picture.pixels; // R G B A
    std::vector<Shot> shots;
    for (std::size_t i = 0; i < pixels.size(); i += 4)
        shots.push_back({{pixels[i], pixels[i + 1], pixels[i + 2]}, {0, 0, 0}, pixels[i + 3]});
    return shots;
}

Shot shoot(scene::Scene scene, std::uint32_t spp) {
    const std::vector<Shot> pixels = shoot_all(std::move(scene), spp);
    const double n = double(pixels.size());
    Shot shot;
    Vec3 squares(0, 0, 0);
    for (const Shot &pixel : pixels) {
        shot.mean += pixel.mean / n;
        shot.alpha += pixel.alpha / n;
    }
    for (const Shot &pixel : pixels) squares += (pixel.mean - shot.mean).cwiseAbs2();
    shot.error = (squares / (n * (n - 1))).cwiseSqrt();
    return shot;
}

void expect_shot(const Shot &shot, const Vec3 &exact, double largest_error, double slack, const std::string &what) {
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(shot.mean[c], exact[c], 4 * shot.error[c] + slack * std::abs(exact[c]))
            << what << ", channel " << c << ", standard error " << shot.error[c];
        EXPECT_LE(shot.error[c], largest_error * std::abs(exact[c])) << what << ": too few samples";
    }
}

void expect_same(const Shot &a, const Shot &b, double largest_error, const std::string &what) {
    for (int c = 0; c < 3; ++c) {
        const double error = std::hypot(a.error[c], b.error[c]), size = std::abs(a.mean[c]);
        EXPECT_NEAR(a.mean[c], b.mean[c], 4 * error + 1e-5 * size) << what << ", channel " << c;
        EXPECT_LE(error, largest_error * size) << what << ": too few samples";
    }
}

double rect_irradiance(double a, double b, double height) {
    const double x = .5 * a / height, y = .5 * b / height, p = std::sqrt(1 + x * x), q = std::sqrt(1 + y * y);
    return 2 * (x / p * std::atan(y / p) + y / q * std::atan(x / q));
}

} // namespace nacre
