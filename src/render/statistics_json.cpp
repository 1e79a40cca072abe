// The document of --stats.
#include "render/statistics.h"
#include <nlohmann/json.hpp>

namespace nacre::render {
namespace {

using namespace shared;
using Json = nlohmann::ordered_json;

Json startup_json(const Startup &startup) {
    return {{"device_s", startup.device},
            {"load_s", startup.load},
            {"bvh_s", startup.bvh},
            {"bvh_tree_s", startup.bvh_parts.tree},
            {"bvh_collapse_s", startup.bvh_parts.collapse},
            {"bvh_flatten_s", startup.bvh_parts.flatten},
            {"clearance_s", startup.clearance},
            {"lights_s", startup.lights},
            {"upload_s", startup.upload},
            {"compile_s", startup.compile},
            {"codegen_s", startup.code_generation},
            {"first_pixel_s", startup.first_pixel}};
}

Json kernel_json(const Statistics::Kernel &kernel) {
    Json out = {{"launches", kernel.launches},
                {"total_s", kernel.seconds},
                {"private_bytes", kernel.compiled.private_bytes},
                {"local_bytes", kernel.compiled.local_bytes},
                {"work_group", kernel.compiled.work_group}};
    if (kernel.compiled.registers) out["registers"] = *kernel.compiled.registers;
    if (kernel.compiled.spill_bytes) out["spill_bytes"] = *kernel.compiled.spill_bytes;
    return out;
}

Json profile_json(const Statistics &statistics) {
    static constexpr const char *names[] = {
#define PROFILE_NAME(name) #name,
        PROFILE_LIST(PROFILE_NAME)
#undef PROFILE_NAME
    };
    const Profile &profile = statistics.profile;
    const auto per = [&](std::uint64_t count, Counter of) { return ratio(double(count), double(statistics[of])); };
    const auto a_second = [&](std::uint64_t count) { return ratio(double(count), statistics.sampling); };
    Json out;
    out["rates"] = {{"samples_per_s", a_second(statistics.samples)},
                    {"rays_per_s", a_second(statistics.rays())},
                    {"walks_per_s", a_second(statistics[COUNTER_walks])},
                    {"steps_per_s", a_second(statistics[COUNTER_steps])}};
    out["nodes_per_ray"] = {{"rays", per(profile[PROFILE_ray_nodes], COUNTER_rays)},
                            {"shadow_rays", per(profile[PROFILE_shadow_nodes], COUNTER_shadow_rays)},
                            {"walk_rays", per(profile[PROFILE_walk_nodes], COUNTER_walk_rays)}};
    out["blocks_per_ray"] = {{"rays", per(profile[PROFILE_ray_blocks], COUNTER_rays)},
                             {"shadow_rays", per(profile[PROFILE_shadow_blocks], COUNTER_shadow_rays)},
                             {"walk_rays", per(profile[PROFILE_walk_blocks], COUNTER_walk_rays)}};
    out["steps_per_walk"] = {{"mean", per(statistics[COUNTER_steps], COUNTER_walks)},
                             {"p50", profile.percentile(0.5)},
                             {"p99", profile.percentile(0.99)},
                             {"max", profile.most_steps}};
    out["clear_share"] = per(profile[PROFILE_clear_steps], COUNTER_steps);
    out["lane_occupancy"] = statistics.lane_occupancy();
    for (int i = 0; i < PROFILE_COUNT; ++i) out["counters"][names[i]] = profile.counters[std::size_t(i)];
    out["histogram"] = Json::array(); // [least steps, walks], bins that have any
    for (std::uint32_t bin = 0; bin < PROFILE_BINS; ++bin)
        if (profile.histogram[bin] > 0) out["histogram"].push_back({first_of_bin(bin), profile.histogram[bin]});
    return out;
}

} // namespace

std::string Statistics::json() const {
    static constexpr const char *names[] = {
#define COUNTER_NAME(name) #name,
        COUNTER_LIST(COUNTER_NAME)
#undef COUNTER_NAME
    };
    Json document;
    document["load_s"] = startup.load;
    document["build_s"] = startup.bvh + startup.clearance;
    document["compile_s"] = startup.compile;
    document["first_pixel_s"] = startup.first_pixel;
    document["sampling_s"] = sampling;
    document["total_s"] = total;
    document["startup"] = startup_json(startup);
    document["samples"] = samples;
    if (adaptive)
        document["adaptive"] = {{"target", adaptive->target},
                                {"error", adaptive->reached},
                                {"converged", adaptive->converged},
                                {"shown_samples", adaptive->shown}};
    document["device"] = device;
    document["generic"] = generic;
    document["options"] = program_options;
    document["features"] = features;
    std::size_t bytes = 0;
    for (const auto &[name, size] : memory) {
        document["memory"][name] = size;
        bytes += size;
    }
    document["memory"]["total"] = bytes;
    for (const Kernel &kernel : kernels) document["kernels"][kernel.compiled.name] = kernel_json(kernel);
    for (int i = 0; i < COUNTER_COUNT; ++i) document["counters"][names[i]] = counters[std::size_t(i)];
    document["counters"]["capped_energy"] = double(counters[COUNTER_capped_energy]) / COUNTER_ENERGY;
    if (counters[COUNTER_non_finite] > 0)
        document["first_non_finite"] = {{"x", bad_pixel_x},
                                        {"y", bad_pixel_y},
                                        {"sample", bad_sample},
                                        {"vertex", bad_step >> 24},
                                        {"step", bad_step & 0xffffff}};
    if (profiled) document["profile"] = profile_json(*this);
    return document.dump(2) + "\n";
}

} // namespace nacre::render
