// What a scene doesn't need and therefore isn't made: the program for all scenes (`--generic`) against that for one.
// Every measurement is a process of its own with an empty cache: what compiles is what a user waits for the first time.
#include "base/error.h"
#include "measure.h"
#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <regex>
#include <unistd.h>

using namespace nacre;
using namespace nacre::bench;

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct Options {
    std::string json, scenes, device = "cpu";
    int spp = 64;
};

struct Side {
    double build = 0;                 // seconds of compiling and code generation
    double sample = 0;                // microseconds, the median of three runs
    std::size_t code = 0, memory = 0; // bytes
    std::vector<std::string> missing; // buffers that are not there
};

struct Row {
    std::string scene;
    Side generic, own;
};

class Scratch {
  public:
    Scratch() : path(fs::temp_directory_path() / fmt::format("nacre_features_{}", getpid())) {
        fs::create_directories(path);
    }
    ~Scratch() { fs::remove_all(path); }
    const fs::path path;
};

/// Scenes of scenes/, in the README's order: features, bear, head.
std::vector<fs::path> scenes(const std::string &filter) {
    std::vector<fs::path> all;
    for (const auto &entry : fs::directory_iterator(NACRE_SCENES "/features"))
        if (entry.path().extension() == ".json") all.push_back(entry.path());
    std::sort(all.begin(), all.end());
    for (const char *model : {"bear/bear.json", "head/head.json"}) all.push_back(fs::path(NACRE_SCENES) / model);
    std::erase_if(all,
                  [&](const fs::path &file) { return !std::regex_search(file.stem().string(), std::regex(filter)); });
    return all;
}

/// Machine code where the driver leaves it in its cache (PoCL's shared objects), else the program's binaries.
std::size_t code_bytes(const fs::path &cache) {
    std::size_t objects = 0, binaries = 0;
    for (const auto &entry : fs::recursive_directory_iterator(cache)) {
        if (entry.path().extension() == ".so") objects += entry.file_size();
        if (entry.path().extension() == ".bin") binaries += entry.file_size();
    }
    return objects > 0 ? objects : binaries;
}

/// Renders in a process of its own; its statistics, or nothing where the scene's files are not there.
std::optional<Json> render(const Scratch &scratch, const fs::path &scene, const std::string &more,
                           const Options &options) {
    const std::string stats = scratch.path / "stats.json";
    const std::string command =
        fmt::format("XDG_CACHE_HOME='{0}/cache' '{1}' render '{2}' -o '{0}/picture.exr' --quiet --size 128x128 --stats "
                    "'{3}' --device '{4}' {5} 2> '{0}/errors'",
                    scratch.path.string(), NACRE_PROGRAM, scene.string(), stats, options.device, more);
    const int status = std::system(command.c_str());
    if (status != 0 && WEXITSTATUS(status) == int(Exit::input)) return {};
    std::ifstream errors(scratch.path / "errors");
    if (status != 0)
        throw Error(Exit::failed, scene, "failed: " + std::string(std::istreambuf_iterator<char>(errors), {}));
    std::ifstream in(stats);
    return Json::parse(in);
}

std::optional<Side> measure(const fs::path &scene, bool generic, const Options &options) {
    const Scratch scratch;
    const std::string more = generic ? "--generic" : "";
    const auto first = render(scratch, scene, more + " --spp 1", options);
    if (!first) return {};
    std::vector<double> samples;
    Json warm;
    for (int run = 0; run < 3; ++run) {
        warm = *render(scratch, scene, fmt::format("{} --spp {}", more, options.spp), options);
        samples.push_back(1e6 * double(warm["sampling_s"]) / double(warm["samples"]));
    }
    Side side;
    side.build = double((*first)["startup"]["compile_s"]) + double((*first)["startup"]["codegen_s"]);
    side.sample = median(samples);
    side.code = code_bytes(scratch.path / "cache");
    side.memory = warm["memory"]["total"];
    for (const auto &[name, bytes] : warm["memory"].items())
        if (bytes == 0) side.missing.push_back(name);
    return side;
}

void print(const Row &row) {
    fmt::print("| `{}` | {:.1f} / {:.1f} | {:.0f} / {:.0f} | {:.1f} / {:.1f} | {:.2f} / {:.2f} | {} |\n", row.scene,
               row.generic.build, row.own.build, double(row.generic.code) / 1e3, double(row.own.code) / 1e3,
               double(row.generic.memory) / 1e6, double(row.own.memory) / 1e6, row.generic.sample, row.own.sample,
               fmt::join(row.own.missing, ", "));
    std::fflush(stdout);
}

Json to_json(const Side &side) {
    return {{"build_s", side.build},
            {"code_bytes", side.code},
            {"memory_bytes", side.memory},
            {"us_per_sample", side.sample},
            {"not_made", side.missing}};
}

int run(const Options &options) {
    fmt::print("| scene | compiling, s | machine code, kB | buffers, MB | us a sample | buffers not made |\n"
               "|---|---|---|---|---|---|\n");
    Json json = Json::array();
    for (const fs::path &scene : scenes(options.scenes)) {
        const auto generic = measure(scene, true, options), own = measure(scene, false, options);
        if (!generic || !own) {
            fmt::print(stderr, "{} skipped: its files are not here (NACRE_ASSETS)\n", scene.stem().string());
            continue;
        }
        print({scene.stem(), *generic, *own});
        json.push_back({{"scene", scene.stem()}, {"generic", to_json(*generic)}, {"own", to_json(*own)}});
    }
    if (!options.json.empty()) write_json(options.json, json);
    return 0;
}

} // namespace

int main(int argc, char **argv) {
    Options options;
    CLI::App app("The program for all scenes / that for one, as a Markdown table, scene by scene");
    app.add_option("--json", options.json, "write the figures to this file, too");
    app.add_option("--scenes", options.scenes,
                   "only scenes with names that this regular expression finds something in");
    app.add_option("--spp", options.spp, "samples per pixel to time")->check(CLI::Range(1, 1 << 16));
    app.add_option("--device", options.device, "OpenCL device");
    CLI11_PARSE(app, argc, argv);
    try {
        return run(options);
    } catch (const std::regex_error &error) {
        fmt::print(stderr, "features: error: --scenes: {}\n", error.what());
        return int(Exit::usage);
    } catch (const Error &error) {
        fmt::print(stderr, "features: error: {}\n", error.what());
        return int(error.code);
    }
}
