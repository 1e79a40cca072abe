#pragma once
#include "oracle/reference_random.h"
#include "oracle/reference_world.h"

namespace nacre::reference {

/// A ray through pixel (x, y), at random within the pixel and, where there is a lens, on it.
Ray camera_ray(const World &world, int x, int y, Random &random);

} // namespace nacre::reference
