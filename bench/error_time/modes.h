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
/// the error of a budget, not its samples, of which it takes 32 and more. Samplers are not among them, there is only
/// one; nor is roulette, which is no setting.
const std::vector<Mode> &modes();

} // namespace nacre::bench
