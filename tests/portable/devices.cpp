// Which device is taken when there are several platforms, and some without devices.
#include "portable/portable.h"
#include "scene/features.h"
#include "shared/features.h"
#include <filesystem>
#include <set>

namespace nacre {
namespace {

namespace fs = std::filesystem;

class Devices : public Cli {
  protected:
    /// The loader sees these libraries and no others; rusticl without a device unless it is enabled.
    Surroundings only(std::initializer_list<const char *> libraries, const std::string &enable = "") const {
        fs::create_directory(folder / "vendors");
        for (const std::string library : libraries) put(folder / "vendors" / (library + ".icd"), library + "\n");
        return {
            .environment = {{"OCL_ICD_VENDORS", path("vendors")}, {"RUSTICL_ENABLE", enable}, {"NACRE_DEVICE", ""}}};
    }
    static constexpr const char *pocl = "libpocl.so.2", *clover = "libMesaOpenCL.so.1",
                                *rusticl = "libRusticlOpenCL.so.1";

    static nlohmann::json list(const Surroundings &surroundings) {
        const Outcome outcome = run({"devices", "--json"}, surroundings);
        EXPECT_EQ(outcome.code, 0) << "signal " << outcome.signal << outcome.err;
        return nlohmann::json::parse(outcome.out);
    }
};

// Whatever comes first in the list, a CPU is PoCL's.
TEST_F(Devices, PoclIsTheDefault) {
    const Surroundings both = only({pocl, rusticl}, "llvmpipe");
    const auto devices = list(both);
    ASSERT_EQ(devices.size(), 2u) << devices;
    ASSERT_EQ(run(small_render(ball, "out.exr", {"--stats", path("stats.json")}), both).code, 0);
    const auto used = json_of("stats.json")["device"];
    for (const auto &device : devices)
        EXPECT_EQ(device["name"] == used, device["platform"] == "Portable Computing Language") << device;
}

TEST_F(Devices, LanesWithinLanesAreRefused) {
    const auto four = small_render(ball, "out.exr", {"--set", "device.lanes=4"});
    expect_error(run(four, only({rusticl}, "llvmpipe")), 4, "device.lanes 0 or 1");
    EXPECT_EQ(run(four, only({pocl})).code, 0);
}

TEST_F(Devices, PlatformsWithoutADeviceAreSkipped) {
    const auto devices = list(only({clover, rusticl, pocl}));
    ASSERT_EQ(devices.size(), 1u) << devices;
    EXPECT_EQ(devices[0]["index"], 0);
    EXPECT_EQ(devices[0]["platform"], "Portable Computing Language");
}

TEST_F(Devices, NothingButPlatformsWithoutADevice) {
    const Surroundings none = only({clover, rusticl});
    EXPECT_EQ(run({"devices"}, none).code, 4);
    expect_error(run(small_render(ball, "out.exr"), none), 4, "no device found");
}

// Asked of real renders: that a clearance field is made, only the geometry and the picture's size tell.
using SmallScenes = Cli;
TEST_F(SmallScenes, NeedEveryFeature) {
    const auto names = scene::feature_names(shared::FEATURE_ALL);
    std::set<std::string> missing(names.begin(), names.end());
    for (const SmallScene &small : small_scenes()) {
        auto options = options_of(small);
        options.insert(options.end(), {"--generic", "--stats", path("stats.json")});
        ASSERT_EQ(run(small_render(small.file(), "out.exr", options), {}, patience).code, 0) << small.name;
        const auto stats = json_of("stats.json");
        for (const auto &name : stats["features"]) missing.erase(name.get<std::string>());
    }
    EXPECT_EQ(missing, std::set<std::string>{});
}

} // namespace
} // namespace nacre
