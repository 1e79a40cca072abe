// No device, or one that cannot be used: exit 4.
#include "cli/cli.h"
#include <algorithm>
#include <filesystem>

namespace nacre {
namespace {

namespace fs = std::filesystem;

TEST_F(Cli, NoSuchDevice) {
    const Outcome outcome = run(small_render(ball, "out.exr", {"--device", "abacus"}));
    expect_error(outcome, 4, "abacus");
    EXPECT_NE(outcome.err.find(" 0: "), std::string::npos) << "it must say what there is: " << outcome.err;
    expect_error(run(small_render(ball, "out.exr", {"--device", "99"})), 4, "99");
    expect_error(run(small_render(ball, "out.exr"), {.environment = {{"NACRE_DEVICE", "sundial"}}}), 4, "sundial");
    EXPECT_EQ(files(), 0u);
}

TEST_F(Cli, NoPlatform) {
    fs::create_directory(folder / "vendors");
    const Surroundings bare{.environment = {{"OCL_ICD_VENDORS", path("vendors")}}};
    expect_error(run(small_render(ball, "out.exr"), bare), 4, "apt-get install pocl-opencl-icd");
    EXPECT_EQ(run({"devices"}, bare).code, 4);
    EXPECT_EQ(files(), 1u);
}

// The scene is refused before a device is asked for: `check` and bad scenes need no OpenCL.
TEST_F(Cli, CheckNeedsNoDevice) {
    fs::create_directory(folder / "vendors");
    EXPECT_EQ(run({"check", ball}, {.environment = {{"OCL_ICD_VENDORS", path("vendors")}}}).code, 0);
}

TEST_F(Cli, KernelsFromAFolder) {
    const fs::path kernels = fs::path(NACRE_SCENES).parent_path() / "kernels";
    fs::copy(kernels, folder / "kernels", fs::copy_options::recursive);
    EXPECT_EQ(run(small_render(ball, "out.exr", {"--kernels", path("kernels")})).code, 0);

    // An error of the compiler comes with file and line; a log has more lines than one.
    const std::string source = bytes_of(folder / "kernels/camera/camera.h");
    put(folder / "kernels/camera/camera.h", source + "\nfloat broken( { return 1.0f; }\n");
    const Outcome broken = run(small_render(ball, "broken.exr", {"--kernels", path("kernels")}));
    EXPECT_EQ(broken.code, 4);
    EXPECT_NE(broken.err.find("nacre: error: "), std::string::npos) << broken.err; // PoCL itself may speak first
    const auto line = std::count(source.begin(), source.end(), '\n') + 2;
    EXPECT_NE(broken.err.find("camera/camera.h:" + std::to_string(line)), std::string::npos) << broken.err;

    fs::remove(folder / "kernels/camera/camera.h");
    expect_error(run(small_render(ball, "missing.exr", {"--kernels", path("kernels")})), 4, "camera.h");
    expect_error(run(small_render(ball, "missing.exr", {"--kernels", path("none")})), 4, "--kernels");
    EXPECT_EQ(files(), 2u) << "the kernels and the first picture";
}

} // namespace
} // namespace nacre
