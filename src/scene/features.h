#pragma once
#include "scene/scene.h"
#include <cstdint>
#include <string>
#include <vector>

namespace nacre::scene {

/// What rendering this scene needs: a mask of shared::Feature. `surface_layers`: albedo, N or depth are asked for;
/// `scatter_layers`: subsurface.zero, .single, .multiple or walk.steps.
std::uint32_t features(const Scene &scene, bool surface_layers, bool scatter_layers = false);

/// Names of the bits of a mask, in lower case.
std::vector<std::string> feature_names(std::uint32_t mask);

} // namespace nacre::scene
