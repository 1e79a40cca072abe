#include "render/statistics.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace nacre::render {

using namespace shared;

std::uint64_t Statistics::rays() const {
    return counters[COUNTER_rays] + counters[COUNTER_shadow_rays] + counters[COUNTER_walk_rays];
}

std::string Statistics::json() const {
    static constexpr const char *names[] = {
#define COUNTER_NAME(name) #name,
        COUNTER_LIST(COUNTER_NAME)
#undef COUNTER_NAME
    };
    nlohmann::ordered_json document;
    document["load_s"] = load;
    document["build_s"] = build;
    document["compile_s"] = compile;
    document["first_pixel_s"] = first_pixel;
    document["sampling_s"] = sampling;
    document["total_s"] = total;
    document["samples"] = samples;
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
    for (int i = 0; i < COUNTER_COUNT; ++i) document["counters"][names[i]] = counters[i];
    document["counters"]["capped_energy"] = double(counters[COUNTER_capped_energy]) / COUNTER_ENERGY;
    if (counters[COUNTER_non_finite] > 0)
        document["first_non_finite"] = {{"x", bad_pixel_x},
                                        {"y", bad_pixel_y},
                                        {"sample", bad_sample},
                                        {"vertex", bad_step >> 24},
                                        {"step", bad_step & 0xffffff}};
    return document.dump(2) + "\n";
}

std::vector<std::string> Statistics::remarks() const {
    std::vector<std::string> lines;
    const auto share = [&](Counter counter) {
        return 100.0 * double(counters[counter]) / double(std::max<std::uint64_t>(1, counters[COUNTER_walks]));
    };
    if (counters[COUNTER_non_finite] > 0)
        lines.push_back(fmt::format(
            "{} samples were NaN or infinite and are black; the first at pixel {}, {}, sample {}, vertex "
            "{}, step {} (--strict makes this an error)",
            counters[COUNTER_non_finite], bad_pixel_x, bad_pixel_y, bad_sample, bad_step >> 24, bad_step & 0xffffff));
    if (counters[COUNTER_escaped] > 0)
        lines.push_back(
            fmt::format("{:.3g} % of the walks left through holes of open meshes and are lost; `nacre check` names "
                        "them",
                        share(COUNTER_escaped)));
    if (share(COUNTER_missed) > 0.01)
        lines.push_back(
            fmt::format("{:.3g} % of the walks slipped through a surface by rounding and left where they were",
                        share(COUNTER_missed)));
    if (counters[COUNTER_capped] > 0)
        lines.push_back(
            fmt::format("{:.3g} % of the walks met subsurface_max_depth; {:.3g} % of the energy below the surface is "
                        "lost",
                        share(COUNTER_capped),
                        100.0 * double(counters[COUNTER_capped_energy]) / COUNTER_ENERGY /
                            double(std::max<std::uint64_t>(1, counters[COUNTER_walks]))));
    return lines;
}

} // namespace nacre::render
