// The test on what it is made for: real renders.
#include "compare/significance.h"
#include "image/rendered.h"
#include <cmath>
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
    scene.render.spp = spp;
    scene.render.seed = seed;
    return scene;
}

compare::Estimate shown(const scene::Scene &scene) {
    render::Options options;
    options.layers.variance = options.layers.samples = true;
    return compare::estimate_of(rendered(scene, options).picture, "a render");
}

TEST(Renders, OnePercentOfGIsFound) {
    const compare::Estimate right = shown(wax(0.8, 40, 512, 1));
    const compare::Verdict verdict = compare::test(shown(wax(0.808, 40, 512, 2)), right, 1e-3);
    EXPECT_TRUE(verdict.different()) << verdict.p;
    EXPECT_LT(verdict.picture.z, 0) << "more forward, deeper, darker";
    const compare::Verdict same = compare::test(shown(wax(0.8, 40, 512, 2)), right, 1e-3);
    EXPECT_FALSE(same.different()) << same.p;
}

// An adaptive render is of the same light as one that is not, in every pixel and tile.
TEST(Renders, AdaptiveShowsTheSame) {
    render::Options options;
    options.layers.variance = options.layers.samples = true;
    options.error = 0.03;
    const compare::Estimate even = shown(wax(0.8, 64, 256, 1));
    const compare::Estimate adaptive =
        compare::estimate_of(rendered(wax(0.8, 64, 4096, 2), options).picture, "an adaptive render");
    const compare::Verdict verdict = compare::test(adaptive, even, 1e-3);
    EXPECT_FALSE(verdict.different()) << verdict.p;
}

/// A ball of skin and its floor, close up, with highlights and shadows' edges: `side` x `side` pixels.
scene::Scene skin(int side, std::uint32_t spp, std::uint32_t seed) {
    scene::Scene scene = io::load_scene(NACRE_SCENES "/features/skin.json", {{"camera.fov", "18"}});
    scene.image.width = scene.image.height = side;
    scene.render.spp = spp;
    scene.render.seed = seed;
    return scene;
}

compare::Estimate crop(const compare::Estimate &whole, int x0, int y0, int side) {
    compare::Estimate part;
    part.width = part.height = side;
    part.level = whole.level;
    for (int y = y0; y < y0 + side; ++y)
        for (int x = x0; x < x0 + side; ++x) {
            const auto pixel = std::size_t(y * whole.width + x);
            part.mean.push_back(whole.mean[pixel]);
            part.variance.push_back(whole.variance[pixel]);
            part.samples.push_back(whole.samples[pixel]);
        }
    return part;
}

/// Expects that of count x count pairs of pictures of 32 x 32 pixels no more are called different than alpha = .05
/// says. They are cut out of two large ones: pixels are independent, so that this is as good as as many renders, and
/// they are not all of the same.
void expect_few_alarms(int count, std::uint32_t spp_a, std::uint32_t spp_b) {
    constexpr int side = 32;
    const compare::Estimate a = shown(skin(side * count, spp_a, 1)), b = shown(skin(side * count, spp_b, 2));
    int alarms = 0;
    for (int y = 0; y < a.height; y += side)
        for (int x = 0; x < a.width; x += side)
            alarms += compare::test(crop(a, x, y, side), crop(b, x, y, side), 0.05).different();
    ::testing::Test::RecordProperty(fmt::format("alarms_{}_{}", spp_a, spp_b), alarms);
    const double expected = 0.05 * count * count;
    EXPECT_LE(alarms, expected + 4 * std::sqrt(0.95 * expected)) << spp_a << " against " << spp_b << " samples";
}

TEST(Renders, FalseAlarmsAreNotMoreThanAlpha) { expect_few_alarms(16, 4, 4); }
TEST(LongRenders, FalseAlarmsAreNotMoreThanAlpha) {
    expect_few_alarms(32, 1, 1);
    expect_few_alarms(32, 2, 2);
    expect_few_alarms(32, 16, 16);
    expect_few_alarms(16, 64, 64);
}
TEST(LongRenders, FalseAlarmsAgainstAReference) {
    expect_few_alarms(32, 16, 4);
    expect_few_alarms(16, 2, 64);
}

} // namespace
} // namespace nacre
