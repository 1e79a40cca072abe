#pragma once
#include "scene/mesh.h"

namespace nacre::bench {

/// Two closed surfaces of about size 2 around the origin, with detail down to their triangles; float-exact positions.
/// They are generated, so that every machine measures the same and nothing has to be downloaded.

/// A lump: a cube blown up to a sphere of 12 side^2 triangles (256: 786,432), its radius a sum of value noise.
scene::Mesh make_blob(int side);

/// A (2, 3) torus knot, a rough tube of 16 around^2 triangles (256: 1,048,576).
scene::Mesh make_knot(int around);

} // namespace nacre::bench
