// --exact: the same picture to the bit on PoCL, one walk at a time or as many side by side as its vectors hold, and
// under Oclgrind, an implementation that shares no built-in with it.
#include "portable/portable.h"
#include <cstring>

namespace nacre {
namespace {

const Surroundings simulator{.environment = {{"NACRE_DEVICE", ""}},
                             .under = {"oclgrind", "--build-options", "-cl-opt-disable"}};

class Exact : public Portable {
  protected:
    PictureFile picture(const std::string &name, std::vector<std::string> more,
                        const Surroundings &surroundings) const {
        more.push_back("--exact");
        const Outcome outcome = run(arguments(name, more), surroundings, patience);
        EXPECT_EQ(outcome.code, 0) << "signal " << outcome.signal << "\n" << outcome.err;
        return read_picture(folder / name).value_or(PictureFile{});
    }
};

std::size_t numbers_that_differ(const PictureFile &a, const PictureFile &b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        count += std::memcmp(&a.pixels[i], &b.pixels[i], sizeof(float)) != 0;
    return count;
}

TEST_P(Exact, SameBits) {
    const std::string pocl = "Portable Computing Language";
    const PictureFile wide = picture("wide.exr", {"--device", pocl, "--stats", path("stats.json")}, {});
    ASSERT_FALSE(wide.pixels.empty());
    expect_as_on_pocl("wide.exr", "stats.json"); // without --exact
    const PictureFile alone = picture("alone.exr", {"--device", pocl, "--set", "device.lanes=1"}, {});
    ASSERT_EQ(alone.pixels.size(), wide.pixels.size());
    EXPECT_EQ(numbers_that_differ(wide, alone), 0u) << "of " << wide.pixels.size() << ", with one lane";
    const PictureFile simulated = picture("simulated.exr", {}, simulator);
    ASSERT_EQ(simulated.pixels.size(), wide.pixels.size());
    EXPECT_EQ(numbers_that_differ(wide, simulated), 0u) << "of " << wide.pixels.size() << ", under Oclgrind";
}

INSTANTIATE_TEST_SUITE_P(Scenes, Exact, testing::ValuesIn(small_scenes()), test_name);

using ExactDevices = Cli;
TEST_F(ExactDevices, OneThatPromisesTooLittleIsRefused) {
    const Surroundings rusticl{.environment = {{"RUSTICL_ENABLE", "llvmpipe"}, {"NACRE_DEVICE", "llvmpipe"}}};
    expect_error(run(small_render(ball, "out.exr", {"--exact"}), rusticl), 4, "does not promise");
}

} // namespace
} // namespace nacre
