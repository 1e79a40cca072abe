#include "error_time/report.h"
#include <fmt/format.h>

namespace nacre::bench {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Interval &interval) {
    return {{"value", interval.value}, {"low", interval.low}, {"high", interval.high}};
}

Json to_json(const Budget &budget, bool scored) {
    Json json = {{"spp", budget.spp},   {"seconds", budget.seconds}, {"cpu_s", budget.cpu},
                 {"mse", budget.mse},   {"relmse", budget.relmse},   {"percentile_99.9", budget.worst},
                 {"flip", budget.flip}, {"bias", budget.bias},       {"bias_z", budget.bias_z}};
    if (scored) json["efficiency"] = to_json(budget.efficiency);
    return json;
}

Json to_json(const Result &result) {
    Json json = {{"name", result.name}, {"passes", result.passes}};
    if (result.p) json["p"] = *result.p;
    json["startup"] = {{"bvh_s", result.startup.bvh},
                       {"clearance_s", result.startup.clearance},
                       {"upload_s", result.startup.upload},
                       {"compile_s", result.startup.compile},
                       {"codegen_s", result.startup.code_generation},
                       {"first_pixel_s", result.startup.first_pixel}};
    if (result.passes) {
        json["slope"] = to_json(result.slope);
        json["equal_time_relmse"] = result.equal_time;
        json["equal_error_seconds"] = result.equal_error;
    }
    for (const Budget &budget : result.budgets) json["budgets"].push_back(to_json(budget, result.passes));
    return json;
}

} // namespace

nlohmann::ordered_json to_json(const Report &report) {
    Json json = {{"device", report.device}, {"remarks", report.remarks}};
    for (const SceneReport &scene : report.scenes) {
        Json out = {{"name", scene.name},
                    {"width", scene.width},
                    {"height", scene.height},
                    {"reference_spp", scene.reference_spp}};
        for (const Result &result : scene.modes) out["modes"].push_back(to_json(result));
        for (const Result &result : scene.peers) {
            Json peer = to_json(result);
            peer["gain"] = to_json(gain(scene.modes.front(), result, &Distance::seconds));
            peer["gain_cpu"] = to_json(gain(scene.modes.front(), result, &Distance::cpu));
            out["peers"].push_back(peer);
        }
        json["scenes"].push_back(out);
    }
    return json;
}

std::string to_csv(const Report &report) {
    std::string out =
        "scene,mode,spp,seed,seconds,cpu_s,mse,relmse,percentile_99.9,flip,relative_variance,level,passes\n";
    for (const SceneReport &scene : report.scenes)
        for (const auto *results : {&scene.modes, &scene.peers})
            for (const Result &result : *results)
                for (const Distance &d : result.distances)
                    out += fmt::format("{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.9g},{}\n",
                                       scene.name, result.name, d.spp, d.seed, d.seconds, d.cpu, d.mse, d.relmse,
                                       d.worst, d.flip, d.variance, d.level, int(result.passes));
    return out;
}

void print(const SceneReport &scene) {
    fmt::print("{}: {}, {} x {}\n", scene.name, scene.shows, scene.width, scene.height);
    fmt::print("  {:20} {:>6} {:>9} {:>9} {:>8} {:>8} {:>7} {:>9}\n", "", "spp", "seconds", "relMSE", "99.9 %", "FLIP",
               "bias z", "1 / (relative variance x seconds), 95 %");
    for (const auto *results : {&scene.modes, &scene.peers})
        for (const Result &result : *results) {
            for (const Budget &b : result.budgets)
                fmt::print("  {:20} {:6} {:9.4f} {:9.3g} {:8.3f} {:8.4f} {:7.2f} {:9.4g} ({:.4g} - {:.4g})\n",
                           result.name, b.spp, b.seconds, b.relmse, b.worst, b.flip, b.bias_z, b.efficiency.value,
                           b.efficiency.low, b.efficiency.high);
            const std::string checked = result.p ? fmt::format("p {:.3g}", *result.p) : "no test, own reference";
            if (!result.passes)
                fmt::print("  {:20} FAILS the check ({}): no score\n", result.name, checked);
            else
                fmt::print(
                    "  {:20} slope {:.3f} ({:.3f} - {:.3f}), {}, equal time {:.2f} x relMSE, equal error {:.2f} x "
                    "seconds\n",
                    result.name, result.slope.value, result.slope.low, result.slope.high, checked, result.equal_time,
                    result.equal_error);
        }
    for (const Result &peer : scene.peers)
        for (const auto &[clock, name] : {std::pair{&Distance::seconds, "seconds"}, {&Distance::cpu, "CPU seconds"}}) {
            const Interval better = gain(scene.modes.front(), peer, clock);
            fmt::print("  1 / (variance x {}), nacre over {}: {:.2f} ({:.2f} - {:.2f})\n", name, peer.name,
                       better.value, better.low, better.high);
        }
    std::fflush(stdout);
}

} // namespace nacre::bench
