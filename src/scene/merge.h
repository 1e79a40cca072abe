#pragma once
#include "scene/mesh.h"

namespace nacre::scene {

/// Adds `part` to `mesh`. Where only one of the two has normals, the other gets geometric ones; uvs likewise, with 0.
void append(Mesh &mesh, Mesh part);

/// Gives every triangle its own three vertices, with its geometric normal.
void make_faceted(Mesh &mesh);

} // namespace nacre::scene
