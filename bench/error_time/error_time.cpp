// Error against time: every mode of every scene at several budgets with independent seeds, against references.
#include "app/interrupt.h"
#include "base/error.h"
#include "error_time/peers.h"
#include "error_time/report.h"
#include "error_time/scenarios.h"
#include "io/atomic_file.h"
#include <CLI/CLI.hpp>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <regex>

using namespace nacre;
using namespace nacre::bench;

namespace {

struct Options {
    std::string json, csv, html, scenes, modes, device = "cpu";
    std::vector<std::uint32_t> budgets{8, 16, 32, 64};
    std::vector<std::string> peers;
    std::uint32_t seeds = 16;
    bool quick = false;
};

// The reference has 16 renders of 4 times the largest budget: its noise is a 64th of one picture's, and is taken off.
constexpr int reference_renders = 16;
constexpr std::uint32_t reference_factor = 4;
constexpr std::uint32_t reference_seed = 1000; // its first; pictures begin at 1

std::vector<const Mode *> chosen_modes(const Options &options, const scene::Scene &scene) {
    const std::regex filter(options.modes);
    std::vector<const Mode *> chosen;
    for (const Mode &mode : modes())
        if (&mode == &modes().front() || (std::regex_search(mode.name, filter) && (!mode.suits || mode.suits(scene))))
            chosen.push_back(&mode);
    return chosen;
}

/// Samples per pixel of all pictures of a scene, but for those that compile.
double samples_of(std::size_t modes, const Options &options) {
    const double once = std::accumulate(options.budgets.begin(), options.budgets.end(), 0.);
    const double most = options.budgets.back();
    return most + once * options.seeds * double(modes) + most * reference_factor * reference_renders;
}

/// In turns, so that what else the machine does meets all modes alike.
std::vector<Series> shoot_all(const device::Device &device, const scene::Scene &scene,
                              const std::vector<const Mode *> &chosen, const Options &options, Pace &pace) {
    std::vector<Series> all;
    for (const Mode *mode : chosen) {
        Series &series = all.emplace_back();
        series.name = mode->name;
        pace.next(mode->name + ", start-up", 0);
        shoot(device, scene, *mode, options.budgets.front(), 0, 1, &series.startup); // compiles; does not count
    }
    const double most = options.budgets.back();
    pace.next("noise", options.budgets.back());
    const double error = noise_of(shoot(device, scene, *chosen.front(), options.budgets.back(), 0, 0).picture);
    for (std::uint32_t seed = 1; seed <= options.seeds; ++seed)
        for (const std::uint32_t spp : options.budgets)
            for (std::size_t i = 0; i < chosen.size(); ++i) {
                pace.next(fmt::format("{}, seed {} of {}", chosen[i]->name, seed, options.seeds), spp);
                all[i].shots.push_back(shoot(device, scene, *chosen[i], spp, seed, error * std::sqrt(most / spp)));
            }
    for (Series &series : all) take_slopes(series.shots, options.budgets.size(), &Shot::cpu);
    return all;
}

SceneReport measure(const device::Device &device, const Scenario &scenario, const Options &options,
                    const std::string &place, Report &report, Pace &pace) {
    SceneReport out{scenario.name, scenario.shows, scenario.scene.image.width, scenario.scene.image.height, 0, {}, {}};
    const std::uint32_t spp = options.budgets.back() * reference_factor;
    out.reference_spp = spp * reference_renders;
    const std::vector<const Mode *> chosen = chosen_modes(options, scenario.scene);
    pace.begin(fmt::format("scene {}, {}", place, scenario.name), samples_of(chosen.size(), options));
    const std::vector<Series> all = shoot_all(device, scenario.scene, chosen, options, pace);
    const Reference reference = make_reference(device, scenario.scene, spp, reference_renders, reference_seed, pace);
    for (const Series &series : all) out.modes.push_back(analyse(series, reference));
    compare_with(out.modes.front(), out.modes);
    for (const std::string &name : options.peers) {
        PeerShots shots = shoot_peer(name, scenario, options.budgets, options.seeds, pace);
        if (!shots.why_not.empty()) {
            report.remarks.push_back(shots.why_not);
            pace.finish();
            fmt::print("{}\n", shots.why_not);
            continue;
        }
        out.peers.push_back(analyse(shots.series, reference_of(shots.references)));
    }
    compare_with(out.modes.front(), out.peers);
    return out;
}

/// Those that are asked for, whole: what is measured is kept, whatever becomes of the next scene.
void write(const Options &options, const Report &report) {
    if (!options.json.empty()) io::write_text(options.json, to_json(report).dump(2) + "\n");
    if (!options.csv.empty()) io::write_text(options.csv, to_csv(report));
    if (!options.html.empty()) io::write_text(options.html, to_page(report));
}

int run(Options options) {
    if (options.quick) {
        options.budgets = {1, 2, 4, 8};
        options.seeds = 4;
    }
    std::sort(options.budgets.begin(), options.budgets.end());
    const device::Device device = device::open_device(options.device);
    Report report;
    report.device =
        fmt::format("{}, {} compute units; {} seeds", device.info.name, device.info.compute_units, options.seeds);
    report.remarks.push_back(
        "adaptive takes 32 samples of every pixel and more: its pictures of smaller budgets are alike.");
    const std::regex filter(options.scenes);
    std::vector<Scenario> chosen = scenarios();
    std::erase_if(chosen, [&](const Scenario &scenario) { return !std::regex_search(scenario.name, filter); });
    if (chosen.empty()) throw Error(Exit::usage, "--scenes", "no scene has a name like " + options.scenes);
    app::catch_interrupts();
    Pace pace;
    try {
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            const std::string place = fmt::format("{} of {}", i + 1, chosen.size());
            SceneReport scene = measure(device, chosen[i], options, place, report, pace);
            report.scenes.push_back(std::move(scene));
            pace.finish();
            print(report.scenes.back());
            write(options, report);
        }
    } catch (const Interrupted &) {
        pace.finish();
        fmt::print(stderr, "error_time: stopped; figures are kept of the scenes that are complete, {} of {}\n",
                   report.scenes.size(), chosen.size());
        return int(Exit::interrupted);
    }
    return int(Exit::done);
}

} // namespace

int main(int argc, char **argv) {
    Options options;
    CLI::App app("Error against time of small scenes, mode by mode and against other renderers");
    app.add_option("--json", options.json, "write all figures to this file");
    app.add_option("--csv", options.csv, "write one line per picture to this file");
    app.add_option("--html", options.html, "write plots and tables to this file, which needs no other");
    app.add_option("--scenes", options.scenes,
                   "only scenes with names that this regular expression finds something in");
    app.add_option("--modes", options.modes, "only such modes, and the default");
    app.add_option("--seeds", options.seeds, "independent pictures of every budget")->check(CLI::Range(2, 900));
    app.add_option("--budgets", options.budgets, "samples per pixel, two numbers or more")
        ->expected(2, 100)
        ->check(CLI::Range(1, 1 << 16));
    app.add_option("--peers", options.peers, "other renderers: cycles, mitsuba")->check(CLI::IsMember(peer_names()));
    app.add_flag("--quick", options.quick, "budgets 1 2 4 8 and four seeds: whether it runs");
    app.add_option("--device", options.device, "OpenCL device");
    CLI11_PARSE(app, argc, argv);
    try {
        return run(options);
    } catch (const std::regex_error &error) {
        fmt::print(stderr, "error_time: error: --scenes or --modes: {}\n", error.what());
        return int(Exit::usage);
    } catch (const Error &error) {
        fmt::print(stderr, "error_time: error: {}\n", error.what());
        return int(error.code);
    }
}
