// nacre profile: its report and its JSON.
#include "cli/cli.h"

namespace nacre {
namespace {

const std::string wax = NACRE_SCENES "/features/subsurface.json";

TEST_F(Cli, ProfileReports) {
    const Outcome outcome = run({"profile", wax, "--size", "16x16", "--json", path("p.json")});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const char *text : {"start-up", "code generation", "trace_paths", "accumulate", "walks", "nodes/ray",
                             "steps per walk", "lane occupancy", "roulette", "NaN"})
        EXPECT_NE(outcome.out.find(text), std::string::npos) << "no " << text << " in\n" << outcome.out;
    const auto json = json_of("p.json");
    EXPECT_EQ(json["samples"], 16 * 16 * 16) << "16 samples a pixel unless --spp says otherwise";
    EXPECT_GT(json["profile"]["rates"]["rays_per_s"].get<double>(), 0);
    EXPECT_GT(json["profile"]["rates"]["walks_per_s"].get<double>(), 0);
    EXPECT_GT(json["profile"]["rates"]["steps_per_s"].get<double>(), 0);
    for (const char *of : {"nodes_per_ray", "blocks_per_ray"})
        for (const char *kind : {"rays", "shadow_rays", "walk_rays"})
            EXPECT_TRUE(json["profile"][of].contains(kind)) << of << " " << kind;
    for (const char *key : {"mean", "p50", "p99", "max"})
        EXPECT_TRUE(json["profile"]["steps_per_walk"].contains(key)) << key;
    for (const char *key : {"clear_share", "lane_occupancy", "counters", "histogram"})
        EXPECT_TRUE(json["profile"].contains(key)) << key;
    EXPECT_GT(json["kernels"]["trace_paths"]["launches"].get<int>(), 0);
    EXPECT_GT(json["kernels"]["trace_paths"]["total_s"].get<double>(), 0);
    for (const char *key : {"private_bytes", "local_bytes", "work_group"})
        EXPECT_TRUE(json["kernels"]["trace_paths"].contains(key)) << key;
    EXPECT_EQ(files(), 1u) << "no picture";
}

TEST_F(Cli, ProfileTakesTheScenesSettings) {
    const Outcome outcome = run({"profile", wax, "--set", "image.width=12", "--set", "image.height=8", "--spp", "2",
                                 "--seed", "5", "--generic", "--json", path("p.json")});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(json_of("p.json")["samples"], 12 * 8 * 2);
    EXPECT_TRUE(json_of("p.json")["generic"].get<bool>());
}

TEST_F(Cli, ProfileCannotBeWritten) {
    const Outcome outcome = run({"profile", wax, "--size", "8x8", "--spp", "1", "--json", path("none/p.json")});
    EXPECT_EQ(outcome.code, 5) << outcome.err;
    EXPECT_NE(outcome.err.find("p.json"), std::string::npos) << outcome.err;
}

// What start-up is made of is less than all of it, and nothing of size is left out.
TEST_F(Cli, StartUpAddsUp) {
    ASSERT_EQ(run(small_render(wax, "out.exr", {"--stats", path("s.json")})).code, 0);
    const auto stats = json_of("s.json"), startup = stats["startup"];
    double sum = 0;
    for (const char *key :
         {"device_s", "load_s", "bvh_s", "clearance_s", "lights_s", "upload_s", "compile_s", "codegen_s"}) {
        ASSERT_TRUE(startup.contains(key)) << key;
        EXPECT_GE(startup[key].get<double>(), 0) << key;
        sum += startup[key].get<double>();
    }
    const double first_pixel = startup["first_pixel_s"];
    EXPECT_EQ(stats["first_pixel_s"], first_pixel);
    EXPECT_LE(sum, first_pixel);
    EXPECT_GT(sum, 0.5 * first_pixel) << stats["startup"];
    for (const char *key : {"device_s", "load_s", "bvh_s", "upload_s", "compile_s"})
        EXPECT_GT(startup[key].get<double>(), 0) << key;
    EXPECT_FALSE(stats.contains("profile"));
}

// PoCL makes machine code at the first launch, unless it has it.
TEST_F(Cli, CodeGenerationIsSeen) {
    const Surroundings own{.environment = {{"XDG_CACHE_HOME", path("cache")}}};
    const auto seconds = [&] {
        EXPECT_EQ(run(small_render(wax, "out.exr", {"--stats", path("s.json")}), own).code, 0);
        return json_of("s.json")["startup"]["codegen_s"].get<double>();
    };
    const double cold = seconds(), warm = seconds();
    EXPECT_GT(cold, 0.1);
    EXPECT_LT(warm, 0.5 * cold);
}

} // namespace
} // namespace nacre
