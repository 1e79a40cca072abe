#pragma once
#include "scene/scene.h"
#include <string>
#include <vector>

namespace nacre::bench {

/// A small picture to measure.
struct Scenario {
    std::string name;
    std::string shows; // one line
    scene::Scene scene;
};

/// The bear, a slab lit from behind, dense and thin balls, and the memo's head where the folders of NACRE_ASSETS have
/// it.
std::vector<Scenario> scenarios();

} // namespace nacre::bench
