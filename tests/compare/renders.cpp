// The test on what it is made for: real renders.
#include "compare/significance.h"
#include "image/rendered.h"
#include <gtest/gtest.h>

namespace nacre {
namespace {

/// A ball of wax in a white sky that is not seen.
scene::Scene wax(double g, int size, std::uint32_t spp, std::uint32_t seed) {
    scene::Scene scene = scene_of(fmt::format(R"({{
        "camera": {{"position": [0, 0, 5], "target": [0, 0, 0], "fov": 26}},
        "image": {{"width": {0}, "height": {0}}},
        "materials": {{"wax": {{"subsurface_weight": 1, "subsurface_albedo": 0.9, "subsurface_radius": 0.05,
            "subsurface_scatter_anisotropy": {1}, "specular_weight": 0.3}}}},
        "objects": [{{"sphere": {{"segments": 48}}, "material": "wax"}}],
        "lights": [{{"type": "environment", "visible": false}},
                   {{"type": "rect", "center": [2, 3, 2], "u": [0.2, 0, -0.2], "v": [-0.1, 0.2, -0.1],
                     "radiance": 60}}]}})",
                                              size, g));
    scene.render.spp = int(spp);
    scene.render.seed = seed;
    return scene;
}

compare::Estimate shown(const scene::Scene &scene) {
    render::Options options;
    options.layers.variance = options.layers.samples = true;
    return compare::estimate_of(rendered(scene, options).picture, "a render");
}

TEST(Renders, OnePercentOfGIsFound) {
    const compare::Estimate right = shown(wax(0.8, 48, 512, 1));
    const compare::Verdict verdict = compare::test(shown(wax(0.808, 48, 512, 2)), right, 1e-3);
    EXPECT_TRUE(verdict.different()) << verdict.p;
    EXPECT_LT(verdict.picture.z, 0) << "more forward, deeper, darker";
    const compare::Verdict same = compare::test(shown(wax(0.8, 48, 512, 2)), right, 1e-3);
    EXPECT_FALSE(same.different()) << same.p;
}

/// How many of these pairs of pictures of 32 x 32 pixels are called different at alpha = .05.
int false_alarms(int pairs, std::uint32_t spp_a, std::uint32_t spp_b) {
    int alarms = 0;
    for (int pair = 0; pair < pairs; ++pair) {
        const auto seed = std::uint32_t(2 * pair);
        alarms +=
            compare::test(shown(wax(0.8, 32, spp_a, seed)), shown(wax(0.8, 32, spp_b, seed + 1)), 0.05).different();
    }
    ::testing::Test::RecordProperty(fmt::format("alarms_{}_{}", spp_a, spp_b), alarms);
    return alarms;
}

// At a rate of .05, four standard deviations more than expected: 50 + 4 * 6.9, and 5 + 4 * 2.2.
TEST(LongRenders, FalseAlarmsAreNotMoreThanAlpha) { EXPECT_LE(false_alarms(1000, 4, 4), 77); }
TEST(LongRenders, FalseAlarmsAgainstAReference) { EXPECT_LE(false_alarms(100, 8, 128), 13); }
TEST(Renders, FalseAlarmsAreNotMoreThanAlpha) { EXPECT_LE(false_alarms(20, 8, 8), 4); }

} // namespace
} // namespace nacre
