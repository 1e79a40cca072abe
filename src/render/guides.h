#pragma once
#include "render/geometry.h"

namespace nacre::render {

/// Appends the modes that guide walks through the scene's materials and tells each where its own are. `materials` are
/// those of the scene, in its order. Nothing where the scene has no guiding. `isotropic`: none of it scatters
/// otherwise.
void add_guides(const scene::Scene &scene, bool isotropic, std::vector<shared::Material> &materials,
                std::vector<shared::GuideMode> &modes);

/// Says of each object, after choose_control, whether its walks are guided: those of some size against their mean free
/// paths, whose surface is nearly flat where a walk goes, as guides have it, and not so thin that there is nothing to
/// guide. Returns whether there is one.
bool choose_guided(const scene::Scene &scene, Geometry &geometry);

} // namespace nacre::render
