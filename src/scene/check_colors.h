#pragma once
#include "scene/scene.h"

namespace nacre::scene {

/// What keeps a flat patch of this material from showing the colour that it asks for, each in a sentence.
std::vector<std::string> check_colors(const Scene &scene, const Material &material);

} // namespace nacre::scene
