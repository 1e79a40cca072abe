#pragma once
#include "io/tree.h"
#include "scene/bounds.h"

namespace nacre::io {

// What a scene gets that says nothing, as the JSON a user would have written: so `--set` reaches it. All lengths and
// radiances follow from the size of `box`: the picture is the same at any scale.

/// A skin-like material, its mean free path 2 % of the box's diagonal.
Json default_skin(const scene::Bounds &box);

/// Grey surroundings, a key light at the upper left in front, and a light behind that shows translucency.
Json default_lights(const scene::Bounds &box);

} // namespace nacre::io
