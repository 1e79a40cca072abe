#pragma once
#include "scene/mesh.h"
#include <span>

namespace nacre::io {

/// Cuts a polygon (indices of corners, in order) into a fan of triangles and adds them to `mesh`, whose positions are
/// there. The fan starts at a corner that sees all of the polygon, where there is one: so concave quads are right too.
void add_polygon(scene::Mesh &mesh, std::span<const std::uint32_t> corners);

} // namespace nacre::io
