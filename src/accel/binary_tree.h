#pragma once
#include "accel/bvh.h"
#include <Eigen/Geometry>

namespace nacre::accel {

/// A node of the binary tree that Embree builds. Leaves hold exactly one triangle.
struct BinaryNode {
    Eigen::AlignedBox3f bounds;
    std::uint32_t count = 0;    // triangles below
    std::uint32_t child[2]{};   // indices, greater than the node's own
    std::uint32_t triangle = 0; // of a leaf (count 1): index in the span
    bool leaf() const { return count == 1; }
};

/// Depth first: the subtree of node i is the nodes from i to i + 2 count - 2, its left child i + 1. Decreasing index is
/// bottom-up. Triangles that
/// cannot be hit are left out; no triangle at all gives no node. Throws Error{Exit::failed} when Embree
/// fails.
std::vector<BinaryNode> build_binary_tree(std::span<const Triangle> triangles);

/// Subtrees of at most this many triangles are what threads share work by.
inline constexpr std::uint32_t subtree_grain = 4096;

} // namespace nacre::accel
