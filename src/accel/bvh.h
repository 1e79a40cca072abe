#pragma once
#include "scene/mesh.h"
#include "shared/bvh.h"
#include <cstdint>
#include <span>
#include <vector>

namespace nacre::accel {

/// Triangles as the BVH sees them: float, in the kernels' units. Primitive ids count on from object to object.
struct Triangle {
    Vec3f v[3];
};

/// Triangles that are not finite or have no area (in float) cannot, and are left out of whatever is built.
bool can_be_hit(const Triangle &triangle);

/// Seconds that trees took to build, in all.
struct BuildTimes {
    double tree = 0;     // the binary tree, Embree's
    double collapse = 0; // which of its subtrees become leaves and wide nodes
    double flatten = 0;  // into the kernels' layout
};

/// Flattened BVH(s), in the layout of kernels/shared/bvh.h. Several trees may share the two arrays.
struct Bvh {
    int width = 16;            // children per node and triangles per leaf block: 16, 8 or 4
    std::vector<float> nodes;  // BVH_NODE_ROWS * width per node
    std::vector<float> blocks; // BVH_BLOCK_ROWS * width per block
    std::uint32_t stack = 0;   // entries the deepest traversal can need at once
    BuildTimes times;
};

/// Builds a tree over triangles[i] with primitive id first_primitive + i, appends it to `bvh`, returns its root (as a
/// child reference: a node, or a leaf when one suffices). Embree builds (rtcBuildBVH), a dynamic-programming collapse
/// makes the wide nodes. Triangles that cannot be hit are left out. An empty span gives a root that nothing hits.
/// Throws Error{Exit::failed} when Embree fails.
std::uint32_t append_tree(Bvh &bvh, std::span<const Triangle> triangles, std::uint32_t first_primitive);

} // namespace nacre::accel
