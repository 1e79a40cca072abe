// What a sample costs, as the scene and the picture grow: kernels' seconds of whole renderings on an OpenCL CPU device.
#include "base/error.h"
#include "measure.h"
#include "scaling/cost.h"
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <memory>

using namespace nacre;
using namespace nacre::bench;

namespace {

struct Options {
    std::string json, device = "cpu", kernels;
    int runs = 5;
    bool quick = false;
    bool one = false; // only print what the base setting costs: how the program asks itself about a number of threads
};

struct Row {
    double value, seconds;
};

struct Group {
    std::string name;
    std::vector<Row> rows;
};

struct Verdict {
    std::string name;
    double value;
    std::string wanted;
    bool holds;
};

Setting base_setting(const Options &options) {
    Setting setting;
    if (options.quick) setting = {.triangles = 1e3, .mean_free_path = 0.05, .pixels = 24, .samples = 1};
    return setting;
}

device::Device open(const Options &options) {
    device::Device device = device::open_device(options.device);
    device.kernel_folder = options.kernels;
    return device;
}

/// PoCL reads its number of threads once: a process for each number.
double seconds_with_threads(int threads, const Options &options) {
    const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
    const std::string command =
        fmt::format("POCL_MAX_PTHREAD_COUNT={} '{}' --one --device '{}' --kernels '{}' {}", threads, program,
                    options.device, options.kernels, options.quick ? "--quick" : "");
    const std::unique_ptr<FILE, int (*)(FILE *)> answer(popen(command.c_str(), "r"), pclose);
    double seconds = 0;
    if (!answer || std::fscanf(answer.get(), "%lf", &seconds) != 1)
        throw Error(Exit::failed, "scaling", fmt::format("the measurement with {} threads failed", threads));
    return seconds;
}

Group measure_threads(const Options &options) {
    std::vector<double> one, two;
    for (int run = 0; run < options.runs; run++) { // in turns
        one.push_back(seconds_with_threads(1, options));
        two.push_back(seconds_with_threads(2, options));
    }
    return {"threads", {{1, median(one)}, {2, median(two)}}};
}

template <typename T>
Group measure(const char *name, const device::Device &device, const Options &options, T Setting::*field,
              std::initializer_list<double> values) {
    Group group{name, {}};
    for (const double value : values) {
        Setting setting = base_setting(options);
        setting.*field = T(value);
        group.rows.push_back({value, seconds_per_sample(device, setting, options.runs)});
    }
    return group;
}

void print(const Group &group) {
    for (const Row &row : group.rows)
        fmt::print("{:16} {:>9g} {:12.1f} {:8.2f}\n", group.name, row.value, 1e9 * row.seconds,
                   row.seconds / group.rows[0].seconds);
    std::fflush(stdout);
}

std::vector<Verdict> judge(const Group &threads, const Group &triangles, const Group &samples) {
    const double growth = triangles.rows.back().seconds / triangles.rows[0].seconds;
    const double speed_up = threads.rows[0].seconds / threads.rows[1].seconds;
    double furthest = 1; // from linear: a sample costs the same, however many
    for (const Row &row : samples.rows) {
        const double ratio = row.seconds / samples.rows[0].seconds;
        if (std::abs(std::log(ratio)) > std::abs(std::log(furthest))) furthest = ratio;
    }
    return {{"cost of most triangles : fewest", growth, "< 4", growth < 4},
            {"cost per sample, furthest from the first", furthest, "0.8 to 1.2", furthest >= 0.8 && furthest <= 1.2},
            {"speed of two threads : one", speed_up, ">= 1.9", speed_up >= 1.9}};
}

nlohmann::json to_json(const std::vector<Group> &groups, const std::vector<Verdict> &verdicts) {
    nlohmann::json json;
    for (const Group &group : groups)
        for (const Row &row : group.rows)
            json["results"].push_back({{"name", fmt::format("{}/{:g}", group.name, row.value)},
                                       {"ns_per_sample", 1e9 * row.seconds},
                                       {"ratio", row.seconds / group.rows[0].seconds}});
    for (const Verdict &v : verdicts)
        json["verdicts"].push_back({{"name", v.name}, {"value", v.value}, {"wanted", v.wanted}, {"holds", v.holds}});
    return json;
}

int run(const Options &options) {
    if (options.one) {
        fmt::print("{:.9g}\n", seconds_per_sample(open(options), base_setting(options), 1));
        return 0;
    }
    fmt::print("medians of {} runs\n{:16} {:>9} {:>12} {:>8}\n", options.runs, "", "", "ns / sample", "ratio");
    std::vector<Group> groups{measure_threads(options)}; // processes are started before the first OpenCL call
    print(groups[0]);
    const device::Device device = open(options);
    const auto add = [&](const Group &group) {
        print(group);
        groups.push_back(group);
    };
    if (options.quick) {
        add(measure("triangles", device, options, &Setting::triangles, {1e3, 1e4}));
        add(measure("mean free path", device, options, &Setting::mean_free_path, {0.1, 1}));
        add(measure("pixels a side", device, options, &Setting::pixels, {16, 32}));
        add(measure("samples", device, options, &Setting::samples, {1, 4}));
    } else {
        add(measure("triangles", device, options, &Setting::triangles, {1e3, 1e4, 1e5, 1e6, 4e6}));
        add(measure("mean free path", device, options, &Setting::mean_free_path, {1e-3, 1e-2, 1e-1, 1}));
        add(measure("pixels a side", device, options, &Setting::pixels, {128, 256, 512, 1024}));
        add(measure("samples", device, options, &Setting::samples, {1, 4, 16, 64}));
    }
    const std::vector<Verdict> verdicts = judge(groups[0], groups[1], groups[4]);
    for (const Verdict &v : verdicts)
        fmt::print("{:41} {:6.2f}  wanted {}: {}\n", v.name, v.value, v.wanted, v.holds ? "yes" : "no");
    if (!options.json.empty()) write_json(options.json, to_json(groups, verdicts));
    return 0;
}

} // namespace

int main(int argc, char **argv) {
    Options options;
    CLI::App app("What a sample costs: against triangles, mean free path, threads, pixels, samples");
    app.add_option("--json", options.json, "write the results to this file");
    app.add_option("--runs", options.runs, "renderings per row; their median counts")->check(CLI::Range(1, 1000));
    app.add_flag("--quick", options.quick, "small pictures of small meshes, to see that it runs");
    app.add_option("--device", options.device, "OpenCL device");
    app.add_option("--kernels", options.kernels, "folder of kernels to take in place of the embedded ones");
    app.add_flag("--one", options.one)->group(""); // internal
    CLI11_PARSE(app, argc, argv);
    try {
        return run(options);
    } catch (const Error &error) {
        fmt::print(stderr, "scaling: error: {}\n", error.what());
        return int(error.code);
    }
}
