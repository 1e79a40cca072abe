// --error and --time from the command line, and what --stats says of them.
#include "cli/cli.h"

namespace nacre {
namespace {

TEST_F(Cli, ErrorEndsARender) {
    const Outcome outcome = run(small_render(NACRE_SCENES "/features/skin.json", "out.exr",
                                             {"--error", "0.1", "--spp", "4096", "--stats", path("s.json")}));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto stats = json_of("s.json");
    EXPECT_EQ(stats["adaptive"]["target"], 0.1);
    EXPECT_EQ(stats["adaptive"]["converged"], 1);
    EXPECT_GT(stats["adaptive"]["error"].get<double>(), 0);
    EXPECT_LT(stats["adaptive"]["error"].get<double>(), 0.15);
    EXPECT_LE(stats["adaptive"]["shown_samples"].get<int>(), stats["samples"].get<int>());
    EXPECT_GE(stats["samples"].get<int>(), 32 * 16 * 12);
    EXPECT_NE(stats["options"].get<std::string>().find("TILE_LIST"), std::string::npos);
    EXPECT_EQ(read_picture(folder / "out.exr")->metadata["nacre:samples"], "adaptive, error 0.1");
}

TEST_F(Cli, ErrorThatIsNotReachedIsSaid) {
    const Outcome outcome =
        run(small_render(NACRE_SCENES "/features/skin.json", "out.png", {"--error", "0.001", "--spp", "32"}));
    EXPECT_EQ(outcome.code, 0);
    EXPECT_NE(outcome.err.find("did not come to an error of 0.1 %"), std::string::npos) << outcome.err;
}

TEST_F(Cli, NothingOfItUnlessAskedFor) {
    ASSERT_EQ(run(small_render(ball, "out.exr", {"--stats", path("s.json")})).code, 0);
    const auto stats = json_of("s.json");
    EXPECT_FALSE(stats.contains("adaptive"));
    EXPECT_EQ(stats["memory"]["tile list"], 0);
    EXPECT_EQ(stats["options"].get<std::string>().find("TILE_LIST"), std::string::npos);
}

// Without --spp, time alone ends it, and not the scene's number of samples.
TEST_F(Cli, TimeEndsARender) {
    const Outcome outcome =
        run({"render", ball, "-o", path("out.exr"), "--size", "16x12", "--time", "0.5", "--stats", path("s.json")});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto stats = json_of("s.json");
    EXPECT_GE(stats["sampling_s"].get<double>(), 0.5);
    EXPECT_LT(stats["sampling_s"].get<double>(), 3);
    EXPECT_GT(stats["samples"].get<int>(), 64 * 16 * 12);
}

} // namespace
} // namespace nacre
