#pragma once
#include "render/upload.h"
#include "shared/guide.h"
#include "shared/returned.h"

namespace nacre::render {

/// Slabs that the twins of walks may be in, and their tables (shared/returned.h).
struct Slabs {
    std::vector<shared::Slab> slabs;
    std::vector<float> transmitted;
};

/// Chooses slabs for the plates of `scene` that have control variates of both their sides, by how thick they are where
/// something gets through; tells `sides`, the light on the objects, which are theirs. `thickness`: below each
/// primitive, in the kernels' units.
Slabs choose_slabs(const scene::Scene &scene, const DeviceScene &uploaded, const std::vector<float> &thickness,
                   std::vector<shared::LightSides> &sides);

} // namespace nacre::render
