// The memo's head, where its file is found: mouth, eyes and nostrils are what a bear has not.
#ifdef NACRE_HEAD
#include "image/furnace_scene.h"
#include <gtest/gtest.h>

namespace nacre {
namespace {

Furnace head() {
    return {.mesh = NACRE_HEAD "/LeePerrySmith.glb",
            .camera = R"("position": [5.4, 1.5, 16.4], "target": [0.3, 1.3, 0], "fov": 19.5)",
            .radius = 0.4};
}

TEST(HeadFurnace, IsExactlyWhiteForEveryMedium) { for_all_media(head(), expect_exactly_white); }

TEST(HeadFurnace, SmoothNormalsMoveNothing) {
    Furnace furnace = head();
    furnace.smooth = "true";
    expect_exactly_white(furnace);
}

TEST(LongHeadFurnace, IsExactlyWhite) {
    Furnace furnace = head();
    furnace.size = 256;
    furnace.spp = 64;
    for_all_media(furnace, expect_exactly_white);
}

} // namespace
} // namespace nacre
#endif
