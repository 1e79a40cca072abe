#pragma once
#include "render/session.h"
#include <string>
#include <vector>

namespace nacre::bench {

/// What a mode changes.
struct Setup {
    scene::Scene scene;
    render::Options options;
    std::uint32_t spp = 0; // the budget
    double error = 0;      // what the default's pictures of this budget are off by: root of the relMSE
};

/// A way to render a scene; all of them have the same expected value.
struct Mode {
    std::string name;
    void (*apply)(Setup &);
    bool (*suits)(const scene::Scene &) = nullptr; // null: every scene
};

/// "default", which every other one is held against, then those that differ from it in one thing. "adaptive" is given
/// the error of a budget, not its samples, of which it takes 32 and more. Sampler and roulette are no settings of a
/// scene; their modes compile kernels with definitions of their own. "sampler_random": independent numbers in the place
/// of Owen-scrambled Sobol pairs. "roulette_*": of walks, other values of WALK_ROULETTE (kernels/walk/walk.h); with
/// none, walks that never leave end when their weights underflow. "roulette_surface_*": of paths, from the first
/// surface on, or none (PATH_ROULETTE_START in kernels/path/path.h).
const std::vector<Mode> &modes();

} // namespace nacre::bench
