// Which bodies' walks are guided (src/render/guides.cpp): those that gain.
#include "image/rendered.h"
#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace nacre {
namespace {

/// A ball of radius 1 in a white sky; its mean free path is that of its red light.
scene::Scene ball(double color, double mean_free_path, double g, double bleed) {
    return scene_of(fmt::format(R"({{"image": {{"width": 16, "height": 16}}, "render": {{"spp": 1}},
        "materials": {{"m": {{"subsurface_weight": 1, "subsurface_color": {}, "subsurface_radius": {},
            "subsurface_radius_scale": [1, 0.35, 0.2], "subsurface_scatter_anisotropy": {}, "subsurface_bleed": {}}}}},
        "objects": [{{"sphere": {{"segments": 64}}, "material": "m"}}],
        "lights": [{{"type": "environment"}}]}})",
                                color, mean_free_path, g, bleed));
}

bool is_guided(const scene::Scene &scene) {
    return std::ranges::count(rendered(scene).statistics.features, "guide_eigen") == 1;
}

// Where a surface bends a control variate takes the noise that a guide would; flat bodies have both.
TEST(GuidedBodies, CurvedOnesHaveAControlVariateOrAGuide) {
    scene::Scene curved = ball(.5, .01, 0, 0);
    EXPECT_FALSE(is_guided(curved));
    curved.render.control = false;
    EXPECT_TRUE(is_guided(curved));
    const scene::Scene flat = ball(.5, .002, 0, 0); // 1000 mean free paths across
    EXPECT_TRUE(is_guided(flat));
    EXPECT_EQ(std::ranges::count(rendered(flat).statistics.features, "control"), 1);
}

// Bright balls lead light across: grey .9 (diffusion length 12.6 mean free paths) of less than two e-folds.
TEST(GuidedBodies, BallsThatLightCrossesAreNot) {
    const auto grey = [](double mean_free_path) {
        scene::Scene scene = ball(.9, mean_free_path, 0, 0);
        scene.materials[0][shared::PARAMETER_subsurface_radius_scale].value = {1, 1, 1};
        return scene;
    };
    EXPECT_FALSE(is_guided(grey(.035))); // 2/3 / (12.6 * .035) = 1.5
    EXPECT_TRUE(is_guided(grey(.02)));   // 2.6
}

} // namespace
} // namespace nacre
