// Counting changes no pixel.
#include "image/rendered.h"
#include <cstring>
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
    EXPECT_EQ(plain.statistics.counters, profiled.statistics.counters);
    const auto &a = plain.picture.pixels, &b = profiled.picture.pixels;
    ASSERT_EQ(a.size(), b.size());
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(float)), 0);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ProfileImage, testing::Values("subsurface", "skin", "nested_shells", "depth_cap"));

} // namespace
} // namespace nacre
