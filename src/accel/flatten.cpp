#include "accel/collapse.h"
#include "base/error.h"
#include <algorithm>
#include <bit>

namespace nacre::accel {
namespace {

/// Writes one tree behind what `bvh` already holds.
class Flattener {
  public:
    Flattener(Bvh &bvh, std::span<const Triangle> triangles, std::uint32_t first_primitive)
        : bvh(bvh), triangles(triangles), first_primitive(first_primitive), width(static_cast<std::size_t>(bvh.width)) {
    }

    std::uint32_t flatten(const std::vector<BinaryNode> &tree);

  private:
    std::uint32_t add_node(float extent);
    std::uint32_t add_leaf(const std::vector<BinaryNode> &tree, std::uint32_t subtree);
    void set_child(std::size_t node, std::size_t slot, const Eigen::AlignedBox3f &bounds);

    Bvh &bvh;
    std::span<const Triangle> triangles;
    const std::uint32_t first_primitive;
    const std::size_t width;
};

std::uint32_t Flattener::add_node(float extent) {
    const std::size_t index = bvh.nodes.size() / (BVH_NODE_ROWS * width);
    if (index >= BVH_LEAF_BIT) throw Error(Exit::failed, "BVH", "more nodes than a child reference can name");
    bvh.nodes.resize(bvh.nodes.size() + BVH_NODE_ROWS * width, 0.0f);
    const Eigen::AlignedBox3f empty(Vec3f::Constant(BVH_EMPTY), Vec3f::Constant(-BVH_EMPTY));
    for (std::size_t slot = 0; slot < width; slot++) set_child(index, slot, empty);
    bvh.nodes[(index * BVH_NODE_ROWS + BVH_ROW_EXTENT) * width] = extent;
    return static_cast<std::uint32_t>(index);
}

void Flattener::set_child(std::size_t node, std::size_t slot, const Eigen::AlignedBox3f &bounds) {
    float *rows = bvh.nodes.data() + node * BVH_NODE_ROWS * width + slot;
    for (int axis = 0; axis < 3; axis++) {
        rows[(2 * axis) * width] = bounds.min()[axis];
        rows[(2 * axis + 1) * width] = bounds.max()[axis];
    }
}

std::uint32_t Flattener::add_leaf(const std::vector<BinaryNode> &tree, std::uint32_t subtree) {
    const std::size_t first = bvh.blocks.size() / (BVH_BLOCK_ROWS * width);
    const std::size_t count = (tree[subtree].count + width - 1) / width;
    if (first + count - 1 > BVH_LEAF_FIRST_MASK)
        throw Error(Exit::failed, "BVH", "more leaf blocks than a child reference can name");
    bvh.blocks.resize(bvh.blocks.size() + count * BVH_BLOCK_ROWS * width, 0.0f);
    for (std::size_t i = 0; i < count * width; i++)
        bvh.blocks[((first + i / width) * BVH_BLOCK_ROWS + BVH_ROW_PRIMITIVE) * width + i % width] =
            std::bit_cast<float>(BVH_NO_PRIMITIVE);

    std::size_t filled = 0;
    std::vector<std::uint32_t> stack{subtree};
    while (!stack.empty()) {
        const BinaryNode &node = tree[stack.back()];
        stack.pop_back();
        if (!node.leaf()) {
            stack.push_back(node.child[1]);
            stack.push_back(node.child[0]);
            continue;
        }
        float *rows = bvh.blocks.data() + (first + filled / width) * BVH_BLOCK_ROWS * width + filled % width;
        for (int k = 0; k < 9; k++) rows[k * width] = triangles[node.triangle].v[k / 3][k % 3];
        rows[BVH_ROW_PRIMITIVE * width] = std::bit_cast<float>(first_primitive + node.triangle);
        filled++;
    }
    return BVH_LEAF_BIT | static_cast<std::uint32_t>(count - 1) << BVH_LEAF_COUNT_SHIFT |
           static_cast<std::uint32_t>(first);
}

/// Depth first, so that a subtree is one stretch of memory.
std::uint32_t Flattener::flatten(const std::vector<BinaryNode> &tree) {
    if (tree.empty()) return add_node(0);
    const Collapse collapse(tree, bvh.width);
    const float extent = tree[0].bounds.min().cwiseAbs().cwiseMax(tree[0].bounds.max().cwiseAbs()).maxCoeff();

    struct Pending {
        std::uint32_t subtree;
        std::size_t slot;     // where in Bvh::nodes its reference goes; the root's goes to the caller
        std::uint32_t pushed; // entries on the traversal stack when a ray comes here
    };
    constexpr std::size_t caller = ~std::size_t(0);
    std::uint32_t root = 0;
    std::vector<Pending> stack{{0, caller, 0}};
    while (!stack.empty()) {
        const Pending next = stack.back();
        stack.pop_back();
        const bool leaf = collapse.leaf(next.subtree);
        const std::uint32_t reference =
            leaf ? add_leaf(tree, next.subtree) : add_node(next.slot == caller ? extent : 0);
        if (next.slot == caller)
            root = reference;
        else
            bvh.nodes[next.slot] = std::bit_cast<float>(reference);
        if (leaf) continue;

        const std::vector<std::uint32_t> children = collapse.children(next.subtree);
        const auto pushed = static_cast<std::uint32_t>(next.pushed + children.size() - 1);
        bvh.stack = std::max(bvh.stack, pushed);
        for (std::size_t slot = children.size(); slot-- > 0;) {
            set_child(reference, slot, tree[children[slot]].bounds);
            stack.push_back(
                {children[slot], (reference * std::size_t(BVH_NODE_ROWS) + BVH_ROW_CHILD) * width + slot, pushed});
        }
    }
    return root;
}

} // namespace

std::uint32_t append_tree(Bvh &bvh, std::span<const Triangle> triangles, std::uint32_t first_primitive) {
    return Flattener(bvh, triangles, first_primitive).flatten(build_binary_tree(triangles));
}

} // namespace nacre::accel
