// A command line that makes no sense: exit 2, one line, nothing written.
#include "cli/cli.h"

namespace nacre {
namespace {

struct Case {
    const char *name;
    std::vector<std::string> arguments;
    const char *says;
};

void PrintTo(const Case &c, std::ostream *out) { *out << c.name; }

class BadOptions : public Cli, public testing::WithParamInterface<Case> {};

TEST_P(BadOptions, ExitTwo) {
    // The scene and the output would do; only the option is wrong.
    expect_error(run(GetParam().arguments, {.folder = folder}), 2, GetParam().says);
    EXPECT_EQ(files(), 0u);
}

std::vector<std::string> render(std::vector<std::string> more) {
    more.insert(more.begin(), {"render", NACRE_SCENES "/features/furnace.json", "-o", "out.exr"});
    return more;
}

INSTANTIATE_TEST_SUITE_P(
    Cases, BadOptions,
    testing::Values(
        Case{"NoCommand", {}, "--help"}, Case{"UnknownCommand", {"rendre"}, "--help"},
        Case{"NoScene", {"render", "-o", "out.exr"}, "scene"},
        Case{"NoOutput", {"render", NACRE_SCENES "/features/furnace.json"}, "--output"},
        Case{"UnknownOption", render({"--samples-per-pixel", "3"}), "--samples-per-pixel"},
        Case{"NoNumber", render({"--spp", "many"}), "many"}, Case{"NoSamples", render({"--spp", "0"}), "--spp"},
        Case{"NegativeSamples", render({"--spp", "-4"}), "--spp"}, Case{"ZeroError", render({"--error", "0"}), "0.02"},
        Case{"NegativeError", render({"--error", "-0.1"}), "--error"},
        Case{"ErrorInPercent", render({"--error", "2"}), "fraction"},
        Case{"ErrorNaN", render({"--error", "nan"}), "nan"},
        Case{"ErrorNoNumber", render({"--error", "small"}), "small"},
        Case{"ErrorOfOneSample", render({"--error", "0.1", "--spp", "1"}), "--spp 2"},
        Case{"ZeroTime", render({"--time", "0"}), "seconds"}, Case{"NegativeTime", render({"--time", "-3"}), "--time"},
        Case{"TimeInfinite", render({"--time", "inf"}), "inf"}, Case{"TimeNaN", render({"--time", "nan"}), "nan"},
        Case{"BadSize", render({"--size", "16"}), "--size 16"},
        Case{"HugeSize", render({"--size", "16x65537"}), "65536"},
        Case{"CropOutside", render({"--crop", "0,0,65,64"}), "--crop"},
        Case{"CropEmpty", render({"--crop", "5,5,5,9"}), "--crop"},
        Case{"UnknownLayer", render({"--aov", "albedo,normals"}), "normals"},
        Case{"SetWithoutValue", render({"--set", "render.spp"}), "PATH=VALUE"},
        Case{"OtherFormat", {"render", NACRE_SCENES "/features/furnace.json", "-o", "out.jpg"}, ".png"}),
    [](const auto &info) { return info.param.name; });

} // namespace
} // namespace nacre
