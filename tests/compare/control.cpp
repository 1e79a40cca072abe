// Walks with a control variate (kernels/walk/twin.h) show the same as walks without, with less noise.
#include "compare/significance.h"
#include "image/rendered.h"
#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace nacre {
namespace {

struct Shown {
    compare::Estimate picture;
    bool controlled;
    double variance; // of the pixels' means, summed
};

Shown shown(scene::Scene scene, bool control, std::uint32_t spp) {
    scene.render.control = control;
    scene.render.seed = control ? 1 : 2;
    scene.render.spp = spp;
    render::Options options;
    options.layers.variance = options.layers.samples = true;
    const Rendered found = rendered(scene, options);
    Shown result{compare::estimate_of(found.picture, "a render"),
                 std::ranges::count(found.statistics.features, "control") == 1, 0};
    for (const auto &pixel : result.picture.variance)
        for (const float channel : pixel) result.variance += double(channel);
    return result;
}

/// `quieter`: how many times.
void expect_same(const scene::Scene &scene, double quieter, std::uint32_t spp = 256) {
    const Shown with = shown(scene, true, spp), without = shown(scene, false, spp);
    EXPECT_TRUE(with.controlled);
    EXPECT_FALSE(without.controlled);
    const compare::Verdict verdict = compare::test(with.picture, without.picture, 1e-4);
    EXPECT_FALSE(verdict.different()) << "p " << verdict.p << ", z " << verdict.pixels.z << " of pixels, "
                                      << verdict.tiles.z << " of tiles, " << verdict.picture.z << " of the picture";
    EXPECT_LT(with.variance * quieter, without.variance);
}

/// A ball two units across in a white sky and before a lamp.
scene::Scene ball(double radius, const std::string &parameters = "", const std::string &scale = "[1, 0.35, 0.2]") {
    return scene_of(fmt::format(R"({{"image": {{"width": 48, "height": 48}},
        "camera": {{"position": [0, 0, 5], "target": [0, 0, 0], "fov": 26}},
        "materials": {{"m": {{"subsurface_weight": 1, "subsurface_color": [0.8, 0.5, 0.4], "subsurface_radius": {},
            "subsurface_radius_scale": {}, "specular_weight": 0{}}}}},
        "objects": [{{"sphere": {{"segments": 128}}, "material": "m"}}],
        "lights": [{{"type": "environment", "radiance": 0.3, "visible": false}},
                   {{"type": "rect", "center": [3, 3, 3], "u": [-1, 2, -1], "v": [2, 0, -2], "radiance": 6}}]}})",
                                radius, scale, parameters));
}

TEST(Control, DenseBall) { expect_same(ball(.004), 10); }
TEST(Control, ForwardBall) { expect_same(ball(.004, R"(, "subsurface_scatter_anisotropy": 0.8)"), 4); }
TEST(Control, BleedingBall) { expect_same(ball(.01, R"(, "subsurface_bleed": 0.5)"), 3); }
TEST(Control, BallOfThreePhases) { expect_same(ball(.01, R"(, "subsurface_scatter_anisotropy": [0.8, 0, -0.5])"), 3); }
// Most walks leave before their twins.
TEST(Control, ThinBall) { expect_same(ball(.2), 1.1); }
// Twins fly farther than any way through the scene: cut there, their ball is .3 % dark in red.
TEST(Control, ThinBleedingBall) { expect_same(ball(.15, R"(, "subsurface_bleed": 0.75)"), 1, 4096); }
TEST(Control, ClassicalWalks) {
    scene::Scene scene = ball(.03);
    scene.render.guiding = shared::GUIDING_NONE;
    expect_same(scene, 2);
}
// A plate of four of red's mean free paths before a lamp, and before it another one: walks leave through either side
// and through the edges, where their twins go on.
TEST(Control, Plates) {
    for (const char *medium : {"", R"(, "subsurface_scatter_anisotropy": 0.8)",
                               R"(, "subsurface_scatter_anisotropy": [0.5, 0, -0.5], "subsurface_bleed": 0.6)"})
        for (const double front : {0., 4.}) {
            SCOPED_TRACE(testing::Message() << medium << ", light in front " << front);
            const scene::Scene scene = scene_of(fmt::format(R"({{"image": {{"width": 32, "height": 32}},
                "camera": {{"position": [0, 0, 6], "target": [0, 0, 0], "fov": 30}},
                "materials": {{"m": {{"subsurface_weight": 1, "subsurface_color": [0.9, 0.7, 0.6], "specular_weight": 0,
                    "subsurface_radius": 0.25, "subsurface_radius_scale": [1, 0.6, 0.5]{}}}}},
                "objects": [{{"box": {{"min": [-2, -2, -1], "max": [2, 2, 0]}}, "material": "m"}}],
                "lights": [{{"type": "rect", "center": [0, 0, -6], "u": [5, 0, 0], "v": [0, 5, 0], "radiance": 10}},
                    {{"type": "rect", "center": [0, 5, 6], "u": [2, 0, 0], "v": [0, -1, 2], "radiance": {}}}]}})",
                                                            medium, front));
            expect_same(scene, 2, 1024);
        }
}
// Each channel by itself, and one channel drawn for every flight.
TEST(Control, ChannelSamplings) {
    for (const shared::ChannelSampling sampling : {shared::CHANNEL_SINGLE, shared::CHANNEL_THROUGHPUT}) {
        SCOPED_TRACE(int(sampling));
        scene::Scene scene = ball(.02, "", "1");
        scene.render.channel_sampling = sampling;
        expect_same(scene, 1.5);
    }
}

class ControlOf : public testing::TestWithParam<const char *> {};

// Highlights, textures, floors, every kind of light, several shells, a hole.
TEST_P(ControlOf, SamePicture) {
    scene::Scene scene = io::load_scene(fmt::format("{}/features/{}.json", NACRE_SCENES, GetParam()),
                                        {{"materials.thing.subsurface_radius", "0.05"}});
    scene.camera.fov = 22;
    scene.image.width = scene.image.height = 48;
    expect_same(scene, 1);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ControlOf,
                         testing::Values("skin", "texture", "environment_image", "point", "emissive_mesh",
                                         "nested_shells", "open_mesh", "normal_map", "reciprocal", "plate"),
                         [](const auto &info) { return std::string(info.param); });

} // namespace
} // namespace nacre
