// On Mesa's rusticl, whose device llvmpipe runs on the CPU.
#include "portable/portable.h"
#include <filesystem>

namespace nacre {
namespace {

const Surroundings rusticl{.environment = {{"RUSTICL_ENABLE", "llvmpipe"}, {"NACRE_DEVICE", "llvmpipe"}}};

class Rusticl : public Portable {};

// The generic program for all scenes: it takes Mesa the better part of a minute, once, and then comes from the caches.
TEST_P(Rusticl, SamePicture) {
    const Outcome outcome = run(arguments("out.exr", {"--stats", path("stats.json"), "--generic"}), rusticl, patience);
    ASSERT_EQ(outcome.code, 0) << "signal " << outcome.signal << "\n" << outcome.err;
    EXPECT_EQ(json_of("stats.json")["device"].get<std::string>().rfind("llvmpipe", 0), 0u);
    expect_as_on_pocl("out.exr", "stats.json");
}

INSTANTIATE_TEST_SUITE_P(Scenes, Rusticl, testing::ValuesIn(small_scenes()), test_name);

TEST_F(Probes, Rusticl) {
    Surroundings surroundings = rusticl;
    surroundings.program = NACRE_TEST_DEVICE;
    expect_ran(run({"--gtest_filter=Program.*:Elementary.*:FlightAccuracy.*:PhaseAccuracy.*"}, surroundings, patience));
}

} // namespace
} // namespace nacre
