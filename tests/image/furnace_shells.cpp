// White furnace on meshes that are not one closed skin.
#include "image/furnace_scene.h"
#include <gtest/gtest.h>

namespace nacre {
namespace {

const std::string camera = R"("position": [0, 1.3, 5], "target": [0, 0, 0], "fov": 30)";

// Shells inside and across one another: the walk counts them, and passes.
TEST(Furnace, NestedShellsAreExactlyWhite) {
    for (const double bleed : {0., 1.})
        expect_exactly_white(
            {.mesh = NACRE_SCENES "/features/shells.ply", .camera = camera, .radius = 0.2, .bleed = bleed});
}

// Through a hole a walk can be lost, never gained.
TEST(Furnace, AnOpenMeshLosesAndIsCounted) {
    const Furnace furnace{.mesh = NACRE_SCENES "/features/open.ply", .camera = camera, .radius = 0.4};
    const Rendered found = rendered(scene_of(furnace));
    EXPECT_GT(found.statistics[shared::COUNTER_escaped], 0u);
    EXPECT_EQ(found.statistics[shared::COUNTER_non_finite], 0u);
    EXPECT_EQ(found.statistics[shared::COUNTER_missed], 0u) << "a hole is no rounding";
    double darkest = 1;
    for (int y = 0; y < furnace.size; ++y)
        for (int x = 0; x < furnace.size; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_LE(found.at(x, y, c), 1 + 1e-4);
                darkest = std::min(darkest, double(found.at(x, y, c)));
            }
    EXPECT_LT(darkest, 0.99);
}

} // namespace
} // namespace nacre
