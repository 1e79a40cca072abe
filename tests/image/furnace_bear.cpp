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

// A slab: white bodies with limbs are walked classically.
TEST(Furnace, SlabIsWhiteInTheMeanWhereWalksAreGuided) {
    for (const auto &[guiding, g] :
         {std::pair{shared::GUIDING_EIGEN, 0.}, {shared::GUIDING_EIGEN, .8}, {shared::GUIDING_DWIVEDI, 0.}}) {
        scene::Scene scene = slab({.g = g}, 5, false);
        scene.render.guiding = guiding;
        scene.materials[0][shared::PARAMETER_subsurface_radius_scale].value = {1, .35, .2};
        const Rendered found = rendered(scene);
        EXPECT_TRUE(std::ranges::any_of(found.statistics.features, [](const std::string &feature) {
            return feature.starts_with("guide_");
        })) << "none is guided";
        for (const Mean &mean : covered_mean(found.picture)) {
            EXPECT_NEAR(mean.value, 1, 4 * mean.error + 1e-5) << "guiding " << guiding << " g " << g;
            EXPECT_LE(mean.error, 5e-3);
        }
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
