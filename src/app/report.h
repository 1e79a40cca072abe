#pragma once
#include "render/statistics.h"
#include <string>

namespace nacre::app {

/// What `nacre profile` prints: start-up, kernels, rates, rays, walks, and what was lost.
std::string report(const render::Statistics &statistics);

} // namespace nacre::app
