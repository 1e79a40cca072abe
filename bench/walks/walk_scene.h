#pragma once
#include "accel/bvh.h"
#include "scene/scene.h"
#include "shared/path.h"
#include <vector>

namespace nacre::bench {

/// A mesh with a medium in a white room: what walks below a surface need, and nothing else. The red channel's mean free
/// path is `mean_free_path` of the longest edge of the mesh's box; green has .35 and blue .2 of it, so that the
/// channels' weights matter.
scene::Scene walk_scene(const scene::Mesh &mesh, double mean_free_path, double anisotropy);

/// The scene's triangles in the kernels' units, as the renderer makes them.
std::vector<accel::Triangle> walk_triangles(const scene::Scene &scene);

/// `count` paths that have just entered the scene's one object, as path_enter and walk_begin (kernels/path/walk.h,
/// kernels/walk/walk.h) leave them: slot i is path i.
std::vector<shared::Path> walk_entries(const scene::Scene &scene, std::span<const accel::Triangle> triangles,
                                       std::size_t count);

/// What became of walks, by either renderer: flights, and radiance per channel, both summed over all walks.
struct Outcome {
    double steps = 0;
    Vec3 radiance{0, 0, 0};
};

Outcome outcome(std::span<const shared::float4> radiance, double steps);

} // namespace nacre::bench
