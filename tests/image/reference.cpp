// Whole pictures against the float64 reference renderer, which shares no code with the kernels.
#include "image/rendered.h"
#include "oracle/agreement.h"
#include <filesystem>
#include <gtest/gtest.h>

namespace nacre {
namespace {

using namespace shared;

/// van de Hulst's inversion (OpenPBR 1.1): any albedo will do, these give colours like those of the scene.
double albedo_for(double x, double g) {
    const double s = 4.09712 + 4.20863 * x - std::sqrt(9.59217 + 41.6808 * x + 17.7126 * x * x);
    return (1 - s * s) / (1 - g * s * s);
}

/// The scene with albedos in place of colours, on a small picture that the thing fills.
scene::Scene small_scene(const std::string &name, int size) {
    scene::Scene scene =
        io::load_scene(std::filesystem::path(NACRE_SCENES) / "features" / (name + ".json"));
    scene.image = {size, size};
    scene.camera.fov = 26;
    for (scene::Material &material : scene.materials) {
        if (material.inversion == INVERSION_NONE) continue;
        material.inversion = INVERSION_NONE;
        Vec3 &color = material[PARAMETER_subsurface_color].value;
        for (int c = 0; c < 3; ++c)
            color[c] = albedo_for(color[c], material[PARAMETER_subsurface_scatter_anisotropy].value[c]);
    }
    return scene;
}

void expect_agreement(scene::Scene scene, std::uint32_t spp, std::uint32_t samples) {
    scene.render.spp = spp;
    render::Options options;
    options.layers.variance = true;
    const auto t0 = std::chrono::steady_clock::now();
    const Rendered found = rendered(scene, options);
    const auto t1 = std::chrono::steady_clock::now();
    const reference::Image expected = reference::render(scene, samples, 1);
    const auto t2 = std::chrono::steady_clock::now();
    const reference::Agreement agreement = reference::compare(found.picture, expected);
    const std::size_t pixels = std::size_t(scene.image.width) * std::size_t(scene.image.height);
    fmt::print("{:.2f}s (sampling {:.2f}) {:.2f}s pixel {:.2f} ({},{},{}; bound {:.2f}) tile {:.2f} (bound {:.2f}) whole {:.2f} {:.2f} {:.2f} diff {:.2e} {:.2e} {:.2e} +- {:.1e} {:.1e} {:.1e}\n",
        std::chrono::duration<double>(t1-t0).count(), found.statistics.sampling, std::chrono::duration<double>(t2-t1).count(),
        agreement.pixel, agreement.x, agreement.y, agreement.channel, reference::largest_deviation(3*pixels), agreement.tile, reference::largest_deviation(3*pixels/16),
        agreement.whole[0], agreement.whole[1], agreement.whole[2],
        agreement.difference[0], agreement.difference[1], agreement.difference[2],
        agreement.error[0], agreement.error[1], agreement.error[2]);
}

TEST(Reference, Try) {
    const char *names = std::getenv("NAMES");
    std::stringstream list(names ? names : "subsurface_albedo diffuse");
    const int spp = std::getenv("SPP") ? std::atoi(std::getenv("SPP")) : 256, samples = std::getenv("SAMPLES") ? std::atoi(std::getenv("SAMPLES")) : 64;
    for (std::string name; list >> name;) {
        fmt::print("{:20} ", name);
        expect_agreement(small_scene(name, 24), spp, samples);
    }
}

} // namespace
} // namespace nacre
