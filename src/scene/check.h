#pragma once
#include "scene/scene.h"

namespace nacre::scene {

/// Something in a scene that renders, but likely not as it was meant.
struct Finding {
    std::string subject; // object, material, or the scene's file
    std::string text;    // what, and what to do
};

/// Looks for holes, triangles turned the wrong way, scattering lengths that do not fit the object, textures without
/// uvs, missing light, and repeats what was read and not used. A scene without findings is not thereby right.
std::vector<Finding> check(const Scene &scene);

} // namespace nacre::scene
