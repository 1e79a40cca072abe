// Under Oclgrind, a simulator that sees out-of-bounds accesses, races and reads of what was never written.
#include "portable/portable.h"
#include <filesystem>
#include <fstream>

namespace nacre {
namespace {

namespace fs = std::filesystem;

/// Without optimisation: with it Oclgrind computes wrong results and says nothing.
Surroundings oclgrind(const std::string &log) {
    return {
        .environment = {{"NACRE_DEVICE", ""}},
        .under = {"oclgrind", "--build-options", "-cl-opt-disable", "--uninitialized", "--data-races", "--log", log}};
}

/// The exit code is the program's, whatever Oclgrind found: its log must be there and be empty.
void expect_clean(const Outcome &outcome, const fs::path &log) {
    ASSERT_EQ(outcome.code, 0) << "signal " << outcome.signal << "\n" << outcome.err << outcome.out;
    ASSERT_TRUE(fs::exists(log)) << "nothing ran under Oclgrind";
    std::ifstream file(log);
    std::string start(2000, '\0');
    file.read(start.data(), std::streamsize(start.size()));
    EXPECT_EQ(start.substr(0, std::size_t(file.gcount())), "");
}

class Oclgrind : public Portable {};

TEST_P(Oclgrind, FindsNothing) {
    const auto outcome = run(arguments("out.exr", {"--stats", path("stats.json")}), oclgrind(path("log")), patience);
    expect_clean(outcome, path("log"));
    EXPECT_EQ(json_of("stats.json")["device"], "Oclgrind Simulator");
    expect_as_on_pocl("out.exr", "stats.json");
}

INSTANTIATE_TEST_SUITE_P(Scenes, Oclgrind, testing::ValuesIn(small_scenes()), test_name);

TEST_F(Probes, Oclgrind) {
    Surroundings surroundings = oclgrind(path("log"));
    surroundings.program = NACRE_TEST_DEVICE;
    const Outcome outcome =
        run({"--gtest_filter=Sobol.OnePointInEveryElementaryInterval:Sobol.DimensionsDiffer"}, surroundings, patience);
    expect_clean(outcome, path("log"));
    expect_ran(outcome);
}

} // namespace
} // namespace nacre
