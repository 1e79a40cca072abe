#pragma once
#include "scene/scene.h"

namespace nacre::scene {

/// Average of a parameter over its texture (the whole picture, linear), or its value where it has none.
Vec3 mean_color(const Scene &scene, const Value &value);

} // namespace nacre::scene
