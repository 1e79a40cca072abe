// White furnace on the bear: a body that takes nothing, in a sky of 1, cannot be seen.
#include "image/box_scene.h"
#include "image/furnace_scene.h"
#include <gtest/gtest.h>

namespace nacre {
namespace {

const std::string bear = NACRE_SCENES "/bear/bear.ply";

TEST(Furnace, BearIsExactlyWhiteForEveryMedium) { for_all_media({.mesh = bear}, expect_exactly_white); }

// Grey extinction: every channel has the same weight whichever was drawn. `single` is the exception, it carries 3 in
// one.
TEST(Furnace, BearIsExactlyWhiteForEveryChannelSampling) {
    for (const char *sampling : {"albedo", "throughput", "hero"})
        expect_exactly_white({.mesh = bear, .g = .8, .bleed = .5, .sampling = sampling});
}

// On a ball: every entry multiplies by 3 or 0, and the bear's limbs make light enter again and again.
TEST(Furnace, BallIsWhiteInTheMeanWithOneChannelPerWalk) {
    scene::Scene scene = ball({}, 5);
    scene.render.channel_sampling = shared::CHANNEL_SINGLE;
    for (const Mean &mean : covered_mean(rendered(scene).picture)) {
        EXPECT_NEAR(mean.value, 1, 4 * mean.error);
        EXPECT_LE(mean.error, 8e-3);
    }
}

// Chromatic extinction is bounded, so that a mean has an error, only where channels are balanced.
TEST(Furnace, BearIsWhiteInTheMeanWithChromaticExtinction) {
    for (const char *sampling : {"throughput", "hero"})
        for (const double bleed : {0., 1.})
            expect_white_mean({.mesh = bear,
                               .radius_scale = "[1, 0.35, 0.2]",
                               .g = .8,
                               .bleed = bleed,
                               .sampling = sampling,
                               .spp = 64},
                              1e-2);
}

TEST(Furnace, BearIsWhiteInTheMeanWhereWalksAreGuided) {
    for (const auto &[guiding, g] : {std::pair{"eigen", 0.}, {"eigen", .8}, {"dwivedi", 0.}}) {
        const Furnace furnace{
            .mesh = bear, .radius = 0.02, .radius_scale = "[1, 0.35, 0.2]", .g = g, .guiding = guiding, .spp = 128};
        const std::vector<std::string> features = rendered(scene_of(furnace)).statistics.features;
        EXPECT_TRUE(std::ranges::count(features, std::string("guide_") + guiding)) << "none is guided";
        expect_white_mean(furnace, 1e-2);
    }
}

// What the layer reflects and what it lets through are one.
TEST(Furnace, BearIsWhiteInTheMeanUnderASpecularLayer) {
    expect_white_mean({.mesh = bear, .specular = 1, .spp = 64}, 2e-3);
}

// Lobes about the shading normal are folded at the geometric horizon: smooth normals move the furnace by nothing at
// all.
TEST(Furnace, SmoothNormalsMoveNothing) {
    expect_exactly_white({.mesh = bear, .smooth = "true"});
    expect_white_mean({.mesh = bear, .specular = 1, .smooth = "true", .spp = 64}, 2e-3);
}

TEST(LongFurnace, Bear) {
    for_all_media({.mesh = bear, .size = 256, .spp = 64}, expect_exactly_white);
    for_all_media({.mesh = bear, .radius_scale = "[1, 0.35, 0.2]", .size = 256, .spp = 256},
                  [](const Furnace &furnace) { expect_white_mean(furnace, 1e-3); });
}

} // namespace
} // namespace nacre
