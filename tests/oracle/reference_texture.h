#pragma once
#include "scene/scene.h"

namespace nacre::reference {

/// Texture `index` of a scene at uv: bilinear, repeated, (0, 0) is the lower left corner of the picture.
Vec3 texture_at(const scene::Scene &scene, std::uint32_t index, const Vec2 &uv);

} // namespace nacre::reference
