#pragma once
#include "accel/binary_tree.h"

namespace nacre::accel {

/// Decides which subtrees of a binary tree become leaves and which nodes merge into one wide node, so that the expected
/// cost of a ray (surface areas: SAH) is least. Dynamic programming over "node n as at most i subtrees": Ylitie,
/// Karras, Laine 2017, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", section 3.1,
/// equations 1-3.
class Collapse {
  public:
    /// `width` children per node and triangles per leaf block, at most 16.
    Collapse(const std::vector<BinaryNode> &tree, int width);

    /// The subtree is one leaf (of at most BVH_LEAF_COUNT_MASK + 1 blocks).
    bool leaf(std::uint32_t node) const { return nodes[node].leaf; }

    /// Roots of the at most `width` subtrees that are the children of the wide node made of `node`.
    std::vector<std::uint32_t> children(std::uint32_t node) const;

  private:
    /// How many subtrees the left and the right child contribute; 0, 0: the node itself is the subtree.
    struct Split {
        std::uint8_t left = 0, right = 0;
    };
    struct Node {
        std::size_t first = 0; // in costs and splits: entry i - 1 is "at most i subtrees"
        Split inner;           // as a wide node
        std::uint8_t size = 0; // entries: more subtrees than triangles, or than the width, change nothing
        bool leaf = false;
    };
    void decide(std::uint32_t index);
    float distribute(const Node &left, const Node &right, int subtrees, Split &split) const;
    void collect(std::uint32_t node, int subtrees, std::vector<std::uint32_t> &out) const;

    const std::vector<BinaryNode> &tree;
    const int width;
    std::vector<Node> nodes;
    std::vector<float> costs;
    std::vector<Split> splits;
};

/// Writes the tree behind what `bvh` already holds and returns its root, a child reference.
std::uint32_t flatten(Bvh &bvh, const std::vector<BinaryNode> &tree, const Collapse &collapse,
                      std::span<const Triangle> triangles, std::uint32_t first_primitive);

} // namespace nacre::accel
