// Building programs: the binary cache, its defences, errors that carry the build log.
#include "device/program.h"
#include "base/error.h"
#include "device/cache.h"
#include "device/source.h"
#include "shared/features.h"
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>

namespace nacre::test {
namespace {

namespace fs = std::filesystem;

/// The default device with our own binary cache on, whatever its quirks say.
device::Device caching_device() {
    device::Device device = device::open_device();
    device.quirks.binary_cache = true;
    return device;
}

device::Variant small_program(const char *salt) {
    device::Variant variant;
    variant.entry = "probe_rays.cl";
    variant.extra = std::string("-DSALT=") + salt; // a cache entry of this test's own
    return variant;
}

fs::path entry_of(const device::Program &program) { return device::cache_folder() / (program.hash + ".bin"); }

TEST(Program, SecondBuildComesFromTheCache) {
    const device::Device device = caching_device();
    const device::Variant variant = small_program("1");
    fs::remove(entry_of(device::build(device, variant)));
    EXPECT_FALSE(device::build(device, variant).cached);
    const device::Program again = device::build(device, variant);
    EXPECT_TRUE(again.cached);
    EXPECT_NO_THROW(cl::Kernel(again.program, "probe_closest"));
    fs::remove(entry_of(again));
}

// Warnings land on a user's terminal. A driver with a cache of its own may only tell them the first time.
TEST(Program, CompilesWithoutAWord) {
    using namespace shared;
    device::Device device = device::open_device();
    device.quirks.binary_cache = false;
    const std::uint32_t all = FEATURE_ALL, walks = FEATURE_SUBSURFACE | FEATURE_ENVIRONMENT;
    for (const std::uint32_t features : std::initializer_list<std::uint32_t>{
             all, all & ~std::uint32_t(FEATURE_CONTROL), walks, walks | FEATURE_CONTROL,
             walks | FEATURE_CONTROL | FEATURE_SLABS, FEATURE_DIFFUSE | FEATURE_RECT}) {
        device::Variant variant;
        variant.features = features;
        variant.lanes = device.quirks.lanes;
        EXPECT_EQ(device::build(device, variant).log, "") << "features " << features;
    }
}

TEST(Program, BrokenCacheEntryIsRebuilt) {
    const device::Device device = caching_device();
    const device::Variant variant = small_program("2");
    const fs::path entry = entry_of(device::build(device, variant));
    const auto size = fs::file_size(entry);
    for (const auto broken : {size / 2, std::uintmax_t(3), std::uintmax_t(0)}) {
        fs::resize_file(entry, broken);
        EXPECT_FALSE(device::build(device, variant).cached) << "truncated to " << broken;
    }
    std::fstream file(entry, std::ios::in | std::ios::out | std::ios::binary);
    const auto middle = std::streamoff(fs::file_size(entry) / 2);
    const int byte = file.seekg(middle).get();
    file.seekp(middle).put(char(~byte));
    file.close();
    EXPECT_FALSE(device::build(device, variant).cached) << "one byte changed";
    EXPECT_TRUE(device::build(device, variant).cached) << "and written again";
    fs::remove(entry);
}

TEST(Program, OptionsAndSourceAreTheKey) {
    const device::Device device = device::open_device();
    const std::string one = device::build(device, small_program("3")).hash;
    EXPECT_EQ(one, device::build(device, small_program("3")).hash);
    EXPECT_NE(one, device::build(device, small_program("4")).hash);
}

TEST(Program, BuildLogNamesFileAndLine) {
    const fs::path folder = fs::path(testing::TempDir()) / "nacre_kernels";
    fs::create_directories(folder / "room");
    std::ofstream(folder / "broken.cl") << "#include \"room/part.h\"\nkernel void k(global int *a) { *a = part(); }\n";
    std::ofstream(folder / "room" / "part.h") << "// a comment\nint part(void) { return nonsense; }\n";
    device::Device device = device::open_device();
    device.kernel_folder = folder;
    device::Variant variant;
    variant.entry = "broken.cl";
    try {
        device::build(device, variant);
        FAIL() << "a program with an error was built";
    } catch (const Error &error) {
        EXPECT_EQ(error.code, Exit::device);
        EXPECT_NE(std::string(error.what()).find("room/part.h:2"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("nonsense"), std::string::npos) << error.what();
    }
    fs::remove_all(folder);
}

TEST(Source, IncludesAreExpandedOnce) {
    const std::string text = device::assemble("render.cl");
    EXPECT_EQ(text.find("#include \""), std::string::npos);
    const std::string guard = "#define NACRE_SHARED_SCENE_H";
    EXPECT_NE(text.find(guard), std::string::npos);
    EXPECT_EQ(text.find(guard), text.rfind(guard));
    EXPECT_THROW(device::assemble("no_such.cl"), Error);
}

TEST(Source, LinesOfTheWholeBecomeThoseOfFiles) {
    const std::string source = "#line 1 \"a.cl\"\n#line 1 \"b.h\"\nint b;\n#line 2 \"a.cl\"\nint a;\nint c;\n";
    EXPECT_EQ(device::located("<kernel>:3:7: error: b\nx\n<kernel>:6:1: c, <kernel>:5:2:\n", source),
              "b.h:1:7: error: b\nx\na.cl:3:1: c, a.cl:2:2:\n");
    EXPECT_EQ(device::located("b.h:1:7: error\n<kernel>:99:1: ?", source), "b.h:1:7: error\n<kernel>:99:1: ?");
    const std::string all = device::assemble("render.cl");
    const auto at = std::count(all.begin(), all.begin() + std::ptrdiff_t(all.find("void trace_paths")), '\n') + 1;
    EXPECT_EQ(device::located(fmt::format("<kernel>:{}:1:", at), all).rfind("render.cl:", 0), 0u);
}

TEST(Devices, SelectorsAndErrors) {
    const auto devices = device::list_devices();
    ASSERT_FALSE(devices.empty());
    EXPECT_EQ(device::open_device("0").info.index, 0);
    EXPECT_EQ(device::open_device(devices[0].name.substr(0, 5)).info.index, 0);
    try {
        device::open_device("no such device");
        FAIL();
    } catch (const Error &error) {
        EXPECT_EQ(error.code, Exit::device);
        EXPECT_NE(std::string(error.what()).find(devices[0].name), std::string::npos) << "names what there is";
    }
}

} // namespace
} // namespace nacre::test
