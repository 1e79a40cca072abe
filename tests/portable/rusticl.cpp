// On Mesa's rusticl, whose device llvmpipe runs on the CPU.
#include "portable/portable.h"
#include <filesystem>
#include <set>

namespace nacre {
namespace {

const Surroundings rusticl{.environment = {{"RUSTICL_ENABLE", "llvmpipe"}, {"NACRE_DEVICE", "llvmpipe"}}};

class Rusticl : public Portable {};

// Each scene's own program: Mesa 22.3 takes 20 to 90 seconds for one, and the square of that for the generic program.
// For the same reason one guided scene, and not those with a diffusion model, which take it more than four minutes:
// Oclgrind runs them all.
std::vector<SmallScene> scenes_that_compile() {
    static const std::set<std::string> names = {"skin",  "depth_cap",     "texture",           "normal_map",
                                                "metal", "emissive_mesh", "environment_image", "diffuse"};
    std::vector<SmallScene> scenes = small_scenes();
    std::erase_if(scenes, [](const SmallScene &scene) { return !names.contains(scene.name); });
    return scenes;
}

TEST_P(Rusticl, SamePicture) {
    const Outcome outcome = run(arguments("out.exr", {"--stats", path("stats.json")}), rusticl, patience);
    ASSERT_EQ(outcome.code, 0) << "signal " << outcome.signal << "\n" << outcome.err;
    EXPECT_EQ(json_of("stats.json")["device"].get<std::string>().rfind("llvmpipe", 0), 0u);
    expect_as_on_pocl("out.exr", "stats.json");
}

INSTANTIATE_TEST_SUITE_P(Scenes, Rusticl, testing::ValuesIn(scenes_that_compile()), test_name);

TEST_F(Probes, Rusticl) {
    Surroundings surroundings = rusticl;
    surroundings.program = NACRE_TEST_DEVICE;
    expect_ran(run({"--gtest_filter=Program.*:Elementary.*:FlightAccuracy.*:PhaseAccuracy.*"}, surroundings, patience));
}

} // namespace
} // namespace nacre
