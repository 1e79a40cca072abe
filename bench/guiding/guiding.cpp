// What guiding is worth: variance times time of pictures, estimator by estimator, against classical walks.
#include "base/error.h"
#include "guiding/variance.h"
#include "measure.h"
#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <regex>

using namespace nacre;
using namespace nacre::bench;
using namespace nacre::shared;

namespace {

struct Options {
    std::string json, filter, device = "cpu", kernels;
    std::uint32_t samples = 8;
    int pairs = 3;
    bool full = false;
};

constexpr Estimator baseline{GUIDING_NONE, CHANNEL_THROUGHPUT}, lambert{GUIDING_NONE, CHANNEL_HERO};
constexpr Estimator defaults{GUIDING_EIGEN, CHANNEL_HERO, true};

struct Result {
    std::string name;
    std::vector<Figures> figures; // the first is the baseline, the last the defaults
    double light_variance = -1;   // without media; models only

    double gain(const Figures &figure) const { return figures[0].cost() / figure.cost(); }
    double relative_gain(const Figures &figure) const {
        return figures[0].relative * figures[0].seconds / (figure.relative * figure.seconds);
    }
    double default_gain() const { return gain(figures.back()); }
};

struct Verdict {
    std::string name;
    double value, wanted; // at least
};

/// Dwivedi's scheme is for isotropic scattering: physics of the memo's section 5.
std::vector<Estimator> estimators_for(const scene::Scene &scene) {
    std::vector<Estimator> all;
    bool isotropic = true;
    for (const scene::Material &material : scene.materials)
        isotropic &= material[PARAMETER_subsurface_scatter_anisotropy].value.isZero();
    for (const Guiding guiding : {GUIDING_NONE, GUIDING_DWIVEDI, GUIDING_EIGEN})
        for (const ChannelSampling sampling : {CHANNEL_THROUGHPUT, CHANNEL_HERO})
            if (guiding != GUIDING_DWIVEDI || isotropic) all.push_back({guiding, sampling});
    all.push_back(defaults);
    return all;
}

void print_header() {
    fmt::print("{:32} {:18} {:>11} {:>10} {:>7} {:>8} {:>9} {:>9}\n", "", "", "s / Msample", "variance", "gain",
               "flights", "99.99%", "largest");
}

void print(const Result &result) {
    for (const Figures &f : result.figures) {
        fmt::print("{:32} {:18} {:11.3f} {:10.3g} {:7.2f} {:8.2f}", result.name, name_of(f.estimator), 1e6 * f.seconds,
                   f.variance, result.gain(f), f.flights);
        if (f.weights) fmt::print(" {:9.2f} {:9.2f}", f.weights->percentile, f.weights->largest);
        if (result.light_variance >= 0)
            fmt::print("  in relative variance {:.2f}; variance of Lambertian surfaces there: {:.2f} of it",
                       result.relative_gain(f), result.light_variance / f.variance);
        fmt::print("\n");
    }
    std::fflush(stdout);
}

Result measure_scenario(const device::Device &device, const Scenario &scenario, bool model, const Options &options) {
    const std::vector<Estimator> estimators = estimators_for(scenario.scene);
    Result result{scenario.name, measure(device, scenario, estimators, options.samples, options.pairs)};
    if (model) {
        const Scenario surfaces{scenario.name, without_media(scenario.scene)};
        result.light_variance = variance_of(device, surfaces, lambert, options.samples);
    }
    return result;
}

/// Of the scenes that were measured.
std::vector<Verdict> judge(const std::vector<Result> &results) {
    std::vector<Verdict> verdicts;
    double least = HUGE_VAL;
    for (const Result &result : results) {
        for (const auto &[name, wanted] : {std::pair{"half_space/skin/g0/b0", 8.},
                                           {"half_space/skin/g0.8/b0", 5.},
                                           {"half_space/grey0.95/g0.8/b0", 10.},
                                           {"slab1_behind/skin/g0/b0", 2.},
                                           {"slab1_behind/skin/g0.8/b0", 2.},
                                           {"head_matte/skin/g0/b0", 1.5},
                                           {"head_matte/skin/g0.8/b0", 1.5},
                                           {"head/skin/g0/b0", 1.5},
                                           {"head/skin/g0.8/b0", 1.5}})
            if (result.name == name) verdicts.push_back({name, result.default_gain(), wanted});
        least = std::min(least, result.default_gain());
    }
    verdicts.push_back({"least gain of all scenes", least, .9});
    return verdicts;
}

nlohmann::json to_json(const Result &result) {
    nlohmann::json json{{"name", result.name}, {"gain", result.default_gain()}};
    if (result.light_variance >= 0) json["light_variance"] = result.light_variance;
    for (const Figures &f : result.figures) {
        nlohmann::json &row = json["estimators"][name_of(f.estimator)];
        row = {{"s_per_msample", 1e6 * f.seconds},
               {"variance", f.variance},
               {"gain", result.gain(f)},
               {"relative_gain", result.relative_gain(f)},
               {"flights", f.flights}};
        if (f.weights) {
            row["largest"] = f.weights->largest;
            row["percentile_99.99"] = f.weights->percentile;
        }
    }
    return json;
}

int run(const Options &options) {
    device::Device device = device::open_device(options.device);
    device.kernel_folder = options.kernels;
    fmt::print("{}; {} samples a pixel, medians of {} runs; gain: variance x time of none_throughput over that of the "
               "estimator\n",
               device.info.name, options.samples, options.pairs);
    print_header();
    std::vector<Result> results;
    const std::regex filter(options.filter);
    const auto measure_all = [&](const std::vector<Scenario> &scenarios, bool models) {
        for (const Scenario &scenario : scenarios)
            if (std::regex_search(scenario.name, filter)) {
                results.push_back(measure_scenario(device, scenario, models, options));
                print(results.back());
            }
    };
    measure_all(body_scenarios(options.full), false);
    measure_all(model_scenarios(options.full), true);
    if (results.empty()) throw Error(Exit::usage, "--filter", "no scene has a name like " + options.filter);

    nlohmann::json json;
    for (const Verdict &v : judge(results)) {
        fmt::print("{:32} {:7.2f}  wanted >= {}: {}\n", v.name, v.value, v.wanted, v.value >= v.wanted ? "yes" : "no");
        json["verdicts"].push_back(
            {{"name", v.name}, {"value", v.value}, {"wanted", v.wanted}, {"holds", v.value >= v.wanted}});
    }
    for (const Result &result : results) json["results"].push_back(to_json(result));
    if (!options.json.empty()) write_json(options.json, json);
    return 0;
}

} // namespace

int main(int argc, char **argv) {
    Options options;
    CLI::App app("Variance x time of guided walks against classical ones, over bodies, media and the memo's head");
    app.add_option("--json", options.json, "write the results to this file");
    app.add_option("--spp", options.samples, "samples per pixel")->check(CLI::Range(1, 1 << 16));
    app.add_option("--pairs", options.pairs, "renderings per estimator, in turns; their median time counts")
        ->check(CLI::Range(1, 1000));
    app.add_option("--filter", options.filter,
                   "only scenes with names that this regular expression finds something in");
    app.add_flag("--full", options.full, "every colour with every g and every bleed");
    app.add_option("--device", options.device, "OpenCL device");
    app.add_option("--kernels", options.kernels, "folder of kernels to take in place of the embedded ones");
    CLI11_PARSE(app, argc, argv);
    try {
        return run(options);
    } catch (const std::regex_error &error) {
        fmt::print(stderr, "guiding: error: --filter: {}\n", error.what());
        return int(Exit::usage);
    } catch (const Error &error) {
        fmt::print(stderr, "guiding: error: {}\n", error.what());
        return int(error.code);
    }
}
