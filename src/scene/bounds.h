#pragma once
#include "scene/scene.h"

namespace nacre::scene {

using Bounds = Eigen::AlignedBox3d;

/// Box of the vertices that triangles use; empty where there are none.
Bounds bounds(const Mesh &mesh);

/// Box of all objects, scene units.
Bounds bounds(const std::vector<Object> &objects);

} // namespace nacre::scene
