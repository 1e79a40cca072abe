#pragma once
#include "render/geometry.h"

namespace nacre::render {

/// Says of each object where its walks have a control variate (kernels/walk/twin.h): where it is thick enough, and the
/// colour that a half-space of its medium returns is known; and whether it is a plate of one medium, with a control
/// variate of both sides. Returns whether there is such an object.
bool choose_control(const scene::Scene &scene, const scene::Frame &frame, std::uint32_t features, Geometry &geometry);

} // namespace nacre::render
