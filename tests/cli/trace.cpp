// --trace and --dump-kernel.
#include "cli/cli.h"
#include "device/context.h"
#include <algorithm>
#include <filesystem>
#include <sys/stat.h>

namespace nacre {
namespace {

namespace fs = std::filesystem;

struct TraceSpan {
    std::string name;
    int track;
    double begin, end;
};

std::vector<TraceSpan> spans_of(const nlohmann::json &trace) {
    std::vector<TraceSpan> spans;
    for (const auto &event : trace["traceEvents"])
        if (event["ph"] == "X")
            spans.push_back(
                {event["name"], event["tid"], event["ts"], event["ts"].get<double>() + event["dur"].get<double>()});
    return spans;
}

constexpr double rounding = 0.01; // microseconds; written to the nanosecond

TEST_F(Cli, TraceIsNested) {
    const std::string scene = NACRE_SCENES "/features/subsurface.json";
    ASSERT_EQ(run(small_render(scene, "out.exr", {"--spp", "20", "--trace", path("t.json")})).code, 0);
    const auto trace = json_of("t.json");
    std::map<std::string, int> tracks;
    for (const auto &event : trace["traceEvents"])
        if (event["ph"] == "M") tracks[event["args"]["name"]] = event["tid"];
    const auto spans = spans_of(trace);
    const auto the = [&](const std::string &name) {
        const auto found = std::find_if(spans.begin(), spans.end(), [&](auto &span) { return span.name == name; });
        EXPECT_NE(found, spans.end()) << name;
        return found == spans.end() ? TraceSpan{} : *found;
    };
    double before = 0;
    for (const char *name :
         {"load scene", "open device", "build BVH", "lights", "upload", "compile", "render", "write picture"}) {
        const TraceSpan span = the(name);
        EXPECT_EQ(span.track, tracks["host"]) << name;
        EXPECT_GE(span.begin, before - rounding) << name << " one after the other";
        EXPECT_GE(span.end, span.begin) << name;
        before = span.end;
    }
    const TraceSpan render = the("render");
    int launches = 0, copies = 0;
    double last = 0;
    for (const TraceSpan &span : spans) {
        if (span.track != tracks["device queue"]) continue;
        EXPECT_GE(span.end, span.begin) << span.name;
        if (span.end <= the("render").begin + rounding && span.name != "trace_paths") continue; // set up before
        EXPECT_GE(span.begin, render.begin - rounding) << span.name;
        EXPECT_LE(span.end, render.end + rounding) << span.name;
        last = std::max(last, span.end);
        launches += span.name == "trace_paths" || span.name == "accumulate";
        copies += span.name == "read counters" || span.name == "read film";
    }
    EXPECT_GE(launches, 4);
    EXPECT_GE(copies, 3);
    EXPECT_GT(last, render.begin + 0.5 * (render.end - render.begin)) << "the device's clock is on the host's";
    EXPECT_LE(the("generate code: trace_paths").end, the("trace_paths").begin + rounding);
    EXPECT_GE(the("read film").begin, the("accumulate").end - rounding) << "what comes after the last launch is there";
    EXPECT_EQ(trace["otherData"]["dropped_spans"], 0);
}

TEST_F(Cli, TraceCannotBeWritten) {
    expect_error(run(small_render(ball, "out.exr", {"--trace", path("none/t.json"), "--quiet"})), 5, "t.json");
}

TEST_F(Cli, DumpedKernelCompilesAgain) {
    const std::string dump = path("deep/dump");
    ASSERT_EQ(run(small_render(ball, "out.exr", {"--dump-kernel", dump})).code, 0);
    for (const char *name : {"render.cl", "render.bin", "build.log", "options.txt"})
        EXPECT_TRUE(fs::is_regular_file(fs::path(dump) / name)) << name;
    EXPECT_GT(fs::file_size(fs::path(dump) / "render.bin"), 1000u);
    const std::string source = bytes_of(fs::path(dump) / "render.cl"),
                      options = bytes_of(fs::path(dump) / "options.txt");
    EXPECT_EQ(source.rfind("// compile with: " + options, 0), 0u) << source.substr(0, 300);
    EXPECT_NE(options.find("-cl-std=CL1.2 -DFEATURES="), std::string::npos) << options;
    const device::Device device = device::open_device();
    cl::Program program(device.context, source);
    program.build({device.info.device}, options.substr(0, options.find('\n')).c_str());
    EXPECT_EQ(cl::Kernel(program, "trace_paths").getInfo<CL_KERNEL_FUNCTION_NAME>(), "trace_paths");
}

TEST_F(Cli, DumpFolderNotWritable) {
    fs::create_directory(folder / "locked");
    chmod(path("locked").c_str(), 0555);
    for (const char *dump : {"locked", "locked/dump"})
        expect_error(run(small_render(ball, "out.exr", {"--dump-kernel", path(dump), "--quiet"}), {.obey_modes = true}),
                     5, "dump");
    chmod(path("locked").c_str(), 0755);
    put(folder / "file", "");
    expect_error(run(small_render(ball, "out.exr", {"--dump-kernel", path("file"), "--quiet"})), 5, "file");
}

} // namespace
} // namespace nacre
