#pragma once
#include "base/vector.h"
#include <cstdint>
#include <vector>

namespace nacre::scene {

/// For each position the index of the first one that is exactly equal (0 and -0 are).
std::vector<std::uint32_t> weld(const std::vector<Vec3> &positions);

} // namespace nacre::scene
