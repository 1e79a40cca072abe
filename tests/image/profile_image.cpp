// Counting changes no pixel.
#include "image/rendered.h"
#include <gtest/gtest.h>

namespace nacre {
namespace {

class ProfileImage : public testing::TestWithParam<const char *> {};

TEST_P(ProfileImage, SameToTheBit) {
    scene::Scene scene = io::load_scene(std::string(NACRE_SCENES "/features/") + GetParam() + ".json");
    scene.image = {32, 32 * scene.image.height / scene.image.width};
    render::Options options;
    options.layers = {.albedo = true, .normal = true, .depth = true, .variance = true, .samples = true};
    scene.render.spp = 3;
    const Rendered plain = rendered(scene, options);
    options.profile = true;
    const Rendered profiled = rendered(scene, options);
    EXPECT_FALSE(plain.statistics.profiled);
    EXPECT_TRUE(profiled.statistics.profiled);
    EXPECT_NE(profiled.statistics.program_options.find("-DPROFILE"), std::string::npos);
    // How far a flight is cleared, and so whether it is traced, depends on its neighbours in the lanes; what it finds
    // does not.
    auto counted = plain.statistics.counters;
    counted[shared::COUNTER_walk_rays] = profiled.statistics.counters[shared::COUNTER_walk_rays];
    EXPECT_EQ(counted, profiled.statistics.counters);
    expect_same_pixels(plain.picture, profiled.picture);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ProfileImage, testing::Values("subsurface", "skin", "nested_shells", "depth_cap"));

} // namespace
} // namespace nacre
