#pragma once
#include "scene/bounds.h"

namespace nacre::scene {

/// Places a camera of known kind and fov in front of `box` (towards +z, slightly above) so that all of it is in the
/// picture, with a margin. Sets position, target and height. `aspect`: width / height of the picture.
void frame(Camera &camera, const Bounds &box, double aspect);

} // namespace nacre::scene
