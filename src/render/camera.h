#pragma once
#include "scene/normalise.h"
#include "scene/scene.h"

namespace nacre::render {

/// The camera as kernels read it: an orthonormal frame and the image plane, in the scene's normalised units.
shared::Camera to_device(const scene::Camera &camera, const scene::ImageSettings &image, const scene::Frame &frame);

} // namespace nacre::render
