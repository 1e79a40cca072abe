#pragma once
#include "accel/embree_scene.h"
#include "shared/path.h"
#include <cstdint>

namespace nacre::bench {

/// The megakernel's walks in C++ with rtcIntersect1: from the entry to the exit and one more ray, which ends in a white
/// sky or on the mesh. `paths` as Megakernel::upload takes them, of a scene with seed 0; `scene` has the mesh in the
/// same units. Writes radiance per slot (rgb) and returns the number of flights.
std::uint64_t walk_with_embree(const EmbreeScene &scene, std::span<const shared::Path> paths,
                               std::span<shared::float4> radiance, unsigned threads);

} // namespace nacre::bench
