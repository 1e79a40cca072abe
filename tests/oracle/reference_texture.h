#pragma once
#include "scene/scene.h"

namespace nacre::reference {

/// Texture `index` of a scene at uv: bilinear, repeated, (0, 0) is the lower left corner of the picture.
Vec3 texture_at(const scene::Scene &scene, std::uint32_t index, const Vec2 &uv);

/// An environment image towards a unit vector: latitude-longitude, column u = 1/2 + atan2(z, x) / 2 pi, row 0 at +y,
/// turned counter-clockwise about +y by its `rotate`; bilinear, round the circle, held at the poles.
Vec3 environment_at(const scene::Light &light, const Vec3 &direction);

} // namespace nacre::reference
