#pragma once
#include "scene/scene.h"
#include <vector>

namespace nacre::render {

/// Says where each material's single-scattering albedo comes from: its value where colour, g and bleed are the same
/// everywhere, else a table that is appended to `similarities` (shared/inversion.h).
void add_albedos(const scene::Scene &scene, std::vector<shared::Material> &materials, std::vector<float> &similarities);

} // namespace nacre::render
