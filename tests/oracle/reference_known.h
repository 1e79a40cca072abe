#pragma once
#include "scene/scene.h"

namespace nacre::reference {

/// Throws Error{Exit::input} where a scene has what the reference does not render: a subsurface_model other than random
/// walks, colours that have to be inverted (it takes subsurface_albedo alone), open meshes with a medium, normal maps
/// on meshes without uvs.
void expect_known(const scene::Scene &scene);

} // namespace nacre::reference
