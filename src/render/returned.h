#pragma once
#include "render/geometry.h"

namespace nacre::render {

/// Appends the tables of what half-spaces return (shared/returned.h) that objects with a control variate ask for, and
/// tells their materials where they are. After choose_control and add_albedos. `isotropic`: no medium of the scene
/// scatters otherwise.
void add_returned(const scene::Scene &scene, const Geometry &geometry, bool isotropic,
                  std::vector<shared::Material> &materials, std::vector<float> &returned);

} // namespace nacre::render
