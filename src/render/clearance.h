#pragma once
#include "render/geometry.h"

namespace nacre::render {

/// Gives each object with subsurface scattering its clearance field where that pays: not where mean free paths are
/// long, nor beyond what so many `paths` (samples of all pixels) can win back. The fields of a scene share
/// accel::clearance_budget.
void add_clearance(const scene::Scene &scene, const scene::Frame &frame, std::uint64_t paths, Geometry &geometry);

} // namespace nacre::render
