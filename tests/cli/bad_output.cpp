// Where the picture cannot be written: exit 5, before the work where that can be known, and nothing half-written.
#include "cli/cli.h"
#include <filesystem>
#include <sys/stat.h>

namespace nacre {
namespace {

TEST_F(Cli, FolderMissing) {
    expect_error(run(small_render(ball, "none/out.exr")), 5, "folder does not exist");
    EXPECT_EQ(files(), 0u);
}

TEST_F(Cli, FolderNotWritable) {
    std::filesystem::create_directory(folder / "locked");
    chmod(path("locked").c_str(), 0555);
    expect_error(run(small_render(ball, "locked/out.exr"), {.obey_modes = true}), 5, "written");
    chmod(path("locked").c_str(), 0755);
    EXPECT_EQ(files(), 1u);
    EXPECT_TRUE(std::filesystem::is_empty(folder / "locked"));
}

TEST_F(Cli, OutputIsAFolder) {
    std::filesystem::create_directory(folder / "out.exr");
    expect_error(run(small_render(ball, "out.exr", {"--quiet"})), 5, "folder");
    EXPECT_EQ(files(), 1u);
}

// A limit on the size of files fails like a full disk does: in the middle of the picture. The old one stays.
TEST_F(Cli, DiskFull) {
    const std::string skin = NACRE_SCENES "/features/skin.json";
    const auto large = small_render(skin, "out.exr", {"--size", "400x400", "--quiet"});
    // The compiler's own files have to fit below the limit too (the preprocessed source takes 1 MB), so the kernel is
    // compiled before.
    ASSERT_EQ(run(large).code, 0);
    put(folder / "out.exr", "the picture of yesterday");
    const Outcome outcome = run(large, {.largest_file = 2 << 20});
    expect_error(outcome, 5, "out.exr");
    EXPECT_EQ(bytes_of(folder / "out.exr"), "the picture of yesterday");
    EXPECT_EQ(files(), 1u);
    EXPECT_EQ(run(large).code, 0) << "without the limit it goes well";
    EXPECT_GT(std::filesystem::file_size(folder / "out.exr"), std::size_t(2 << 20));
}

TEST_F(Cli, StatisticsCannotBeWritten) {
    expect_error(run(small_render(ball, "out.exr", {"--stats", path("none/stats.json"), "--quiet"})), 5, "stats.json");
}

} // namespace
} // namespace nacre
