#pragma once
#include "scene/scene.h"

namespace nacre::render {

/// Appends the modes that guide walks through the scene's materials and tells each where its own are. `materials` are
/// those of the scene, in its order. Nothing where the scene has no guiding.
void add_guides(const scene::Scene &scene, std::vector<shared::Material> &materials,
                std::vector<shared::GuideMode> &modes);

} // namespace nacre::render
