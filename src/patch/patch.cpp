#include "patch/patch.h"
#include <cmath>

namespace nacre::patch {
namespace {

using namespace shared;

/// Where a walk meets a triangle is rounded by some 1e-7 of the triangle's size, which must be much less than a mean
/// free path: the front, at z = 0, is made of squares around squares, down to about `smallest`.
scene::Mesh deep_box(double smallest) {
    scene::Mesh mesh;
    const auto square = [&](double half, double z) {
        for (const auto &[x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
            mesh.positions.push_back({half * x, half * y, z});
    };
    const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    };
    // The band between the squares that begin at vertices a and b, counter-clockwise as seen from where b lies within
    // a.
    const auto band = [&](std::uint32_t a, std::uint32_t b) {
        for (std::uint32_t k = 0; k < 4; ++k) quad(a + k, a + (k + 1) % 4, b + (k + 1) % 4, b + k);
    };
    square(1, -1);
    quad(3, 2, 1, 0);
    std::uint32_t last = 0;
    for (double half = 1; half > smallest / 2; half /= 4) {
        square(half, 0);
        band(last, last + 4);
        last += 4;
    }
    quad(last, last + 1, last + 2, last + 3);
    return mesh;
}

} // namespace

scene::Scene patch_scene(const scene::Material &material, double depth, int pixels) {
    scene::Scene scene;
    scene.file = "patch";
    scene.image = {pixels, pixels};
    scene.render.max_depth = 0;
    scene.render.control = false; // a control variate would show the colour asked for whatever walks return
    const double radius = 1 / depth;
    scene.camera.kind = CAMERA_ORTHOGRAPHIC;
    scene.camera.position = {0, 0, 0.5};
    scene.camera.height = 50 * radius;

    scene::Material &medium = scene.materials.emplace_back(material);
    const auto set = [&](Parameter p, double value) { medium[p] = {Vec3::Constant(value), -1}; };
    set(PARAMETER_subsurface_weight, 1);
    set(PARAMETER_subsurface_radius, radius);
    set(PARAMETER_subsurface_radius_scale, 1);
    set(PARAMETER_specular_weight, 0);
    set(PARAMETER_base_metalness, 0);
    set(PARAMETER_emission_luminance, 0);
    scene::Material &black = scene.materials.emplace_back();
    black[PARAMETER_base_color].value = Vec3::Zero();
    black[PARAMETER_specular_weight].value = Vec3::Zero();

    scene.objects.push_back({.name = "half-space", .mesh = deep_box(50 * radius), .material = 0});
    // A speck behind the camera puts the face at the scene's centre, where coordinates are small and their rounding is
    // much less than a mean free path.
    scene.objects.push_back(
        {.name = "speck", .mesh = scene::make_box({-5e-4, -5e-4, 0.999}, {5e-4, 5e-4, 1}), .material = 1});
    scene.lights.emplace_back(); // an environment of radiance 1
    return scene;
}

Color mean_color(const io::Picture &picture) {
    const std::size_t channels = picture.channels.size(), count = picture.pixels.size() / channels;
    Color color;
    for (std::size_t c = 0; c < 3; ++c) {
        double sum = 0, squares = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const double value = picture.pixels[i * channels + c];
            sum += value;
            squares += value * value;
        }
        const double mean = sum / double(count);
        color.value[c] = mean;
        color.error[c] = std::sqrt(std::max(0.0, squares / double(count) - mean * mean) / double(count - 1));
    }
    return color;
}

Color measure(const device::Device &device, const scene::Material &material, double error,
              const std::function<void(double)> &report) {
    constexpr double depth = 5e5;
    scene::Scene scene = patch_scene(material, depth, 64);
    scene.render.spp = 16;
    Color mean;
    double samples = 0;
    for (;; ++scene.render.seed) {
        render::Session session(device, scene, {});
        session.render(scene.render.spp);
        const Color found = mean_color(session.picture());
        // Rounds weigh as their samples do: standard errors say too little of small ones.
        const double share = scene.render.spp / (samples + scene.render.spp);
        samples += scene.render.spp;
        double worst = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            mean.value[c] += share * (found.value[c] - mean.value[c]);
            mean.error[c] = std::hypot((1 - share) * mean.error[c], share * found.error[c]);
            worst = std::max(worst, mean.error[c]);
        }
        if (report) report(std::min(1.0, std::pow(error / std::max(worst, 1e-30), 2)));
        if (worst <= error) return mean;
        scene.render.spp = std::uint32_t(std::clamp(samples * (std::pow(worst / error, 2) - 1), 16.0, 512.0));
    }
}

} // namespace nacre::patch
