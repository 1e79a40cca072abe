#pragma once
#include "oracle/reference_rays.h"
#include "scene/scene.h"

namespace nacre::reference {

/// The normal that texture `index` has at uv, in world space, given the unperturbed one, the triangle and its corners'
/// uvs. Maps are in tangent space as OpenGL has it: x along growing u, y along growing v, both of the picture as it
/// lies on the surface.
Vec3 mapped_normal(const scene::Scene &scene, std::uint32_t index, const Vec2 &uv, const Vec3 &normal,
                   const Triangle &triangle, const std::array<Vec2, 3> &corners);

} // namespace nacre::reference
