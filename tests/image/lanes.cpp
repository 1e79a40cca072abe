// How walks are brought to the machine does not show: any number of lanes, with and without clearance fields, the same
// image to the bit. One lane takes another way through the kernel, a path per work-item.
#include "image/rendered.h"
#include <filesystem>
#include <gtest/gtest.h>

namespace nacre {
namespace {

class Lanes : public testing::TestWithParam<const char *> {
  protected:
    void SetUp() override {
        scene = io::load_scene(std::filesystem::path(NACRE_SCENES) / "features" / (std::string(GetParam()) + ".json"));
        scene.image = {32, 32};
        scene.render.spp = 4;
    }
    Rendered with(int lanes, bool clearance) {
        scene.lanes = lanes;
        scene.render.clearance = clearance;
        render::Options options;
        options.layers = {.zero = true, .single = true, .multiple = true, .steps = true};
        return rendered(scene, options);
    }
    scene::Scene scene;
};

TEST_P(Lanes, SameImage) {
    const Rendered automatic = with(0, true);
    for (const int lanes : lane_counts()) {
        SCOPED_TRACE(lanes);
        expect_same_pixels(automatic.picture, with(lanes, true).picture);
    }
}

TEST_P(Lanes, SameImageWithoutClearance) {
    const Rendered on = with(0, true), off = with(0, false);
    expect_same_pixels(on.picture, off.picture);
    EXPECT_LT(on.statistics[shared::COUNTER_walk_rays], off.statistics[shared::COUNTER_walk_rays])
        << "the field skips nothing";
    EXPECT_EQ(on.statistics[shared::COUNTER_steps], off.statistics[shared::COUNTER_steps]);
}

// Flight laws, channel samplings, several shells and objects, holes, textures, a cap, diffusion models beside walks.
INSTANTIATE_TEST_SUITE_P(Scenes, Lanes,
                         testing::Values("skin", "bleed", "reciprocal", "channel_single", "channel_albedo",
                                         "channel_throughput", "nested_shells", "open_mesh", "texture", "depth_cap",
                                         "emissive_mesh", "internal_reflection", "subsurface_models", "plate"),
                         [](const auto &info) { return std::string(info.param); });

} // namespace
} // namespace nacre
