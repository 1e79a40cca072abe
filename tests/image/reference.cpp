// Whole pictures against the float64 reference renderer (oracle/reference.h), which shares no code with the kernels:
// camera, surfaces, walks and lights together, as one scene after another has them.
#include "image/rendered.h"
#include "oracle/agreement.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>

namespace nacre {
namespace {

using namespace shared;
namespace fs = std::filesystem;

/// van de Hulst's inversion (OpenPBR 1.1). Any albedos would do; these give colours about those of the scene.
double albedo_for(double x, double g) {
    const double s = 4.09712 + 4.20863 * x - std::sqrt(9.59217 + 41.6808 * x + 17.7126 * x * x);
    return (1 - s * s) / (1 - g * s * s);
}

/// One of scenes/features with albedos in place of colours (so that both renderers take the same), on 24 x 24 pixels
/// that its thing nearly fills.
scene::Scene small_scene(const std::string &name) {
    scene::Scene scene = io::load_scene(fs::path(NACRE_SCENES) / "features" / (name + ".json"));
    scene.image = {24, 24};
    scene.camera.fov = 26;
    for (scene::Material &material : scene.materials) {
        if (material.inversion == INVERSION_NONE) continue;
        material.inversion = INVERSION_NONE;
        Vec3 &color = material[PARAMETER_subsurface_color].value;
        const Vec3 &g = material[PARAMETER_subsurface_scatter_anisotropy].value;
        for (int c = 0; c < 3; ++c) color[c] = albedo_for(color[c], g[c]);
    }
    return scene;
}

void expect_agreement(scene::Scene scene, std::uint32_t samples) {
    scene.render.spp = samples;
    render::Options options;
    options.layers.variance = true;
    const io::Picture picture = rendered(scene, options).picture;
    const reference::Agreement found = reference::compare(picture, reference::render(scene, samples, 1));

    const std::size_t numbers = 3 * std::size_t(scene.image.width) * std::size_t(scene.image.height);
    EXPECT_LT(found.pixel, reference::largest_deviation(numbers))
        << "at pixel " << found.x << ", " << found.y << ", channel " << found.channel;
    EXPECT_LT(found.tile, reference::largest_deviation(numbers / 16));
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_LE(found.whole[c], 4) << "channel " << c << ": the mean is off by " << found.difference[c]
                                     << " of itself, standard error " << found.error[c];
    EXPECT_LE(found.all, 4) << "the mean over all channels";
}

std::string name_of(const testing::TestParamInfo<std::string> &info) { return info.param; }

class Reference : public testing::TestWithParam<std::string> {};

TEST_P(Reference, SamePicture) { expect_agreement(small_scene(GetParam()), 512); }

// Guided chromatic walks with g, a flight law, shells, an interface, and a light without extent over a coat.
INSTANTIATE_TEST_SUITE_P(Scenes, Reference,
                         testing::Values("anisotropy", "reciprocal", "nested_shells", "internal_reflection", "point"),
                         name_of);

class AllScenes : public testing::TestWithParam<std::string> {};

TEST_P(AllScenes, SamePicture) { expect_agreement(small_scene(GetParam()), 2048); }

/// All scenes that the reference renders, but two: where extinction has a colour the channel samplings `single` and
/// `albedo` have no variance that samples could tell.
std::vector<std::string> scenes() {
    std::vector<std::string> found;
    for (const auto &entry : fs::directory_iterator(fs::path(NACRE_SCENES) / "features")) {
        const std::string name = entry.path().stem();
        const bool unknown = name == "open_mesh" || name == "dipole" || name == "better_dipole" || name == "burley" ||
                             name == "subsurface_models";
        const bool wild = name == "channel_single" || name == "channel_albedo";
        if (entry.path().extension() == ".json" && !unknown && !wild) found.push_back(name);
    }
    std::sort(found.begin(), found.end());
    return found;
}

INSTANTIATE_TEST_SUITE_P(LongReference, AllScenes, testing::ValuesIn(scenes()), name_of);

} // namespace
} // namespace nacre
