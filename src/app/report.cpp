#include "app/report.h"
#include <fmt/format.h>

namespace nacre::app {
namespace {

using namespace shared;
using render::ratio;
using render::Statistics;

std::string startup_table(const render::Startup &startup) {
    std::string out = "start-up                s\n";
    for (const auto &[name, seconds] : {std::pair{"open device", startup.device},
                                        {"load scene", startup.load},
                                        {"build BVH", startup.bvh},
                                        {"clearance field", startup.clearance},
                                        {"lights", startup.lights},
                                        {"upload", startup.upload},
                                        {"compile", startup.compile},
                                        {"code generation", startup.code_generation},
                                        {"to first pixels", startup.first_pixel}})
        out += fmt::format("  {:<16} {:6.3f}\n", name, seconds);
    return out;
}

std::string kernel_table(const Statistics &statistics) {
    double all = 0;
    for (const auto &kernel : statistics.kernels) all += kernel.seconds;
    std::string out =
        "kernel          launches   total ms   mean ms    share  private B  local B  registers  spill B\n";
    for (const auto &kernel : statistics.kernels) {
        const auto known = [](const std::optional<int> &value) { return value ? fmt::format("{}", *value) : "-"; };
        out += fmt::format("  {:<14} {:7} {:10.2f} {:9.3f} {:6.1f} % {:10} {:8} {:>10} {:>8}\n", kernel.compiled.name,
                           kernel.launches, 1e3 * kernel.seconds, 1e3 * ratio(kernel.seconds, double(kernel.launches)),
                           100 * ratio(kernel.seconds, all), kernel.compiled.private_bytes, kernel.compiled.local_bytes,
                           known(kernel.compiled.registers), known(kernel.compiled.spill_bytes));
    }
    return out;
}

std::string rate_table(const Statistics &statistics) {
    std::string out = fmt::format("in {:7.3f} s of kernels     M    M/s\n", statistics.sampling);
    for (const auto &[name, count] : {std::pair{"samples", statistics.samples},
                                      {"rays", statistics.rays()},
                                      {"walks", statistics[COUNTER_walks]},
                                      {"steps", statistics[COUNTER_steps]}})
        out += fmt::format("  {:<12} {:11.3f} {:6.3f}\n", name, 1e-6 * double(count),
                           1e-6 * ratio(double(count), statistics.sampling));
    return out;
}

std::string ray_table(const Statistics &statistics) {
    struct Kind {
        const char *name;
        Counter rays;
        ProfileCounter nodes, blocks;
    };
    static constexpr Kind kinds[] = {{"surface", COUNTER_rays, PROFILE_ray_nodes, PROFILE_ray_blocks},
                                     {"shadow", COUNTER_shadow_rays, PROFILE_shadow_nodes, PROFILE_shadow_blocks},
                                     {"walk", COUNTER_walk_rays, PROFILE_walk_nodes, PROFILE_walk_blocks}};
    std::string out = "rays              number    share  nodes/ray  triangle blocks/ray\n";
    for (const Kind &kind : kinds) {
        const double rays = double(statistics[kind.rays]);
        out += fmt::format("  {:<10} {:11.0f} {:6.1f} % {:10.2f} {:20.2f}\n", kind.name, rays,
                           100 * ratio(rays, double(statistics.rays())),
                           ratio(double(statistics.profile[kind.nodes]), rays),
                           ratio(double(statistics.profile[kind.blocks]), rays));
    }
    return out;
}

std::string walk_table(const Statistics &statistics) {
    const render::Profile &profile = statistics.profile;
    const double walks = double(statistics[COUNTER_walks]), steps = double(statistics[COUNTER_steps]);
    return fmt::format("walks\n"
                       "  steps per walk     mean {:.2f}, p50 {:.0f}, p99 {:.0f}, max {}\n"
                       "  steps without ray  {:.1f} %\n"
                       "  lane occupancy     {:.1f} % of {}\n",
                       ratio(steps, walks), profile.percentile(0.5), profile.percentile(0.99), profile.most_steps,
                       100 * ratio(double(profile[PROFILE_clear_steps]), steps), 100 * statistics.lane_occupancy(),
                       statistics.lanes);
}

std::string loss_table(const Statistics &statistics) {
    const double walks = double(statistics[COUNTER_walks]);
    std::string out = "ended early       number  per walk\n";
    for (const auto &[name, counter] : {std::pair{"roulette", COUNTER_roulette},
                                        {"depth cap", COUNTER_capped},
                                        {"open mesh", COUNTER_escaped},
                                        {"slipped", COUNTER_missed},
                                        {"NaN, infinity", COUNTER_non_finite}})
        out += fmt::format("  {:<13} {:8}  {:8.3g}\n", name, statistics[counter],
                           ratio(double(statistics[counter]), walks));
    return out + fmt::format("  energy lost to the cap: {:.3g} % of the walks'\n",
                             100 * ratio(double(statistics[COUNTER_capped_energy]) / COUNTER_ENERGY, walks));
}

} // namespace

std::string report(const Statistics &statistics) {
    return startup_table(statistics.startup) + "\n" + kernel_table(statistics) + "\n" + rate_table(statistics) + "\n" +
           ray_table(statistics) + "\n" + walk_table(statistics) + "\n" + loss_table(statistics);
}

} // namespace nacre::app
