#pragma once
#include "scene/normalise.h"
#include "scene/scene.h"
#include "shared/scene.h"
#include <vector>

namespace nacre::render {

/// The lights of a scene as kernels read them: environments, rects, points and directions, then the triangles of meshes
/// that emit, each with its share of the total power; and the tables they are drawn from.
struct LightSet {
    std::vector<shared::Light> lights;
    std::vector<shared::AliasEntry> table;
    std::vector<shared::AliasEntry> environment_table;
    std::vector<shared::float4> environment; // rgb and share of the light, per texel
    std::vector<std::uint32_t> first_light;  // per object: Light of its first triangle, or NO_LIGHT
    std::uint32_t environment_count = 0, rect_count = 0;
    double unit = 1; // radiance of 1 in the kernels, in the scene's units: mean radiance from all the lights' power
};

/// Primitives are counted from object to object, as in the BVH.
LightSet build_lights(const scene::Scene &scene, const scene::Frame &frame);

} // namespace nacre::render
