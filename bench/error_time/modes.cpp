#include "error_time/modes.h"

namespace nacre::bench {
namespace {

using namespace shared;

/// Dwivedi's scheme is made for isotropic scattering.
bool isotropic(const scene::Scene &scene) {
    for (const scene::Material &material : scene.materials)
        if (!material[PARAMETER_subsurface_scatter_anisotropy].value.isZero()) return false;
    return true;
}

/// Without roulette, nothing but max_depth ends paths between white walls.
bool limited(const scene::Scene &scene) { return scene.render.max_depth > 0; }

template <ChannelSampling sampling> void channel(Setup &setup) { setup.scene.render.channel_sampling = sampling; }
template <Guiding guiding> void guide(Setup &setup) { setup.scene.render.guiding = guiding; }
template <int lanes> void side_by_side(Setup &setup) { setup.scene.lanes = lanes; }

void adaptive(Setup &setup) {
    setup.options.error = setup.error;
    setup.spp *= 256; // no tile needs more
}

} // namespace

const std::vector<Mode> &modes() {
    static const std::vector<Mode> all = {
        {"default", [](Setup &) {}},
        {"channel_single", channel<CHANNEL_SINGLE>},
        {"channel_albedo", channel<CHANNEL_ALBEDO>},
        {"channel_throughput", channel<CHANNEL_THROUGHPUT>},
        {"guiding_none", guide<GUIDING_NONE>},
        {"guiding_dwivedi", guide<GUIDING_DWIVEDI>, isotropic},
        {"no_control", [](Setup &setup) { setup.scene.render.control = false; }},
        {"no_clearance", [](Setup &setup) { setup.scene.render.clearance = false; }},
        {"lanes_1", side_by_side<1>},
        {"lanes_4", side_by_side<4>},
        {"lanes_8", side_by_side<8>},
        {"lanes_16", side_by_side<16>},
        {"generic", [](Setup &setup) { setup.options.generic = true; }},
        {"adaptive", adaptive},
        {"highlights_1", [](Setup &setup) { setup.options.definitions = "-DHIGHLIGHT_CANDIDATES=1u"; }},
        {"sampler_random", [](Setup &setup) { setup.options.definitions = "-DSOBOL_VERTICES=0u"; }},
        {"roulette_none", [](Setup &setup) { setup.options.definitions = "-DWALK_ROULETTE=0.0f"; }},
        {"roulette_0.1", [](Setup &setup) { setup.options.definitions = "-DWALK_ROULETTE=0.1f"; }},
        {"roulette_0.5", [](Setup &setup) { setup.options.definitions = "-DWALK_ROULETTE=0.5f"; }},
        {"roulette_surface_1", [](Setup &setup) { setup.options.definitions = "-DPATH_ROULETTE_START=1u"; }},
        {"roulette_surface_none", [](Setup &setup) { setup.options.definitions = "-DPATH_ROULETTE_START=0xffffffffu"; },
         limited},
    };
    return all;
}

} // namespace nacre::bench
