#include "render/statistics.h"
#include <fmt/format.h>

namespace nacre::render {

using namespace shared;

std::uint64_t Statistics::rays() const {
    return counters[COUNTER_rays] + counters[COUNTER_shadow_rays] + counters[COUNTER_walk_rays];
}

double ratio(double a, double b) { return b > 0 ? a / b : 0; }

double Statistics::lane_occupancy() const {
    return ratio(double(profile[PROFILE_lane_active]), double(profile[PROFILE_lane_turns]) * lanes);
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
    if (adaptive && adaptive->converged < 1)
        lines.push_back(
            fmt::format("{:.3g} % of the picture did not come to an error of {:.3g} %; more --spp or --time",
                        100 * (1 - adaptive->converged), 100 * adaptive->target));
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
