#pragma once
#include "scene/mesh.h"

namespace nacre::scene {

/// Whether every edge (between welded positions) is passed as often one way as the other: no way out but through the
/// surface.
bool is_closed(const Mesh &mesh);

} // namespace nacre::scene
