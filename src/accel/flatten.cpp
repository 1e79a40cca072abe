#include "accel/collapse.h"
#include "base/error.h"
#include "base/parallel.h"
#include <algorithm>
#include <bit>
#include <chrono>

namespace nacre::accel {
namespace {

/// Writes one tree behind what `bvh` already holds.
class Flattener {
  public:
    Flattener(Bvh &bvh, const std::vector<BinaryNode> &tree, std::span<const Triangle> triangles,
              std::uint32_t first_primitive)
        : bvh(bvh), tree(tree), triangles(triangles), first_primitive(first_primitive),
          width(static_cast<std::size_t>(bvh.width)), blocks(bvh.blocks.size() / (BVH_BLOCK_ROWS * width)) {}

    std::uint32_t flatten(const Collapse &collapse);

  private:
    struct Leaf {
        std::uint32_t subtree;
        std::size_t first; // block
    };
    std::uint32_t add_node(float extent);
    std::uint32_t add_leaf(std::uint32_t subtree);
    void fill(const Leaf &leaf);
    void set_child(std::size_t node, std::size_t slot, const Eigen::AlignedBox3f &bounds);

    Bvh &bvh;
    const std::vector<BinaryNode> &tree;
    std::span<const Triangle> triangles;
    const std::uint32_t first_primitive;
    const std::size_t width;
    std::size_t blocks;       // given to leaves, of this tree or those before
    std::vector<Leaf> leaves; // to be filled in the end, by all cores
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

std::uint32_t Flattener::add_leaf(std::uint32_t subtree) {
    const std::size_t first = blocks, count = (tree[subtree].count + width - 1) / width;
    if (first + count - 1 > BVH_LEAF_FIRST_MASK)
        throw Error(Exit::failed, "BVH", "more leaf blocks than a child reference can name");
    leaves.push_back({subtree, first});
    blocks += count;
    return BVH_LEAF_BIT | static_cast<std::uint32_t>(count - 1) << BVH_LEAF_COUNT_SHIFT |
           static_cast<std::uint32_t>(first);
}

/// Into blocks of zeros.
void Flattener::fill(const Leaf &leaf) {
    const std::uint32_t count = tree[leaf.subtree].count;
    std::size_t slot = 0; // counted through the blocks
    const auto row = [&](std::size_t k) -> float & {
        return bvh.blocks[((leaf.first + slot / width) * BVH_BLOCK_ROWS + k) * width + slot % width];
    };
    for (std::uint32_t i = leaf.subtree; i < leaf.subtree + 2 * count - 1; i++) {
        if (!tree[i].leaf()) continue;
        for (std::size_t k = 0; k < 9; k++) row(k) = triangles[tree[i].triangle].v[k / 3][static_cast<int>(k % 3)];
        row(BVH_ROW_PRIMITIVE) = std::bit_cast<float>(first_primitive + tree[i].triangle);
        slot++;
    }
    for (; slot % width != 0; slot++) row(BVH_ROW_PRIMITIVE) = std::bit_cast<float>(BVH_NO_PRIMITIVE);
}

/// Depth first, so that a subtree is one stretch of memory.
std::uint32_t Flattener::flatten(const Collapse &collapse) {
    if (tree.empty()) return add_node(0);
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
        const std::uint32_t reference = leaf ? add_leaf(next.subtree) : add_node(next.slot == caller ? extent : 0);
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
    bvh.blocks.resize(blocks * BVH_BLOCK_ROWS * width);
    constexpr std::size_t batch = 256;
    parallel_for((leaves.size() + batch - 1) / batch, [&](std::size_t i) {
        for (std::size_t k = i * batch; k < std::min((i + 1) * batch, leaves.size()); k++) fill(leaves[k]);
    });
    return root;
}

} // namespace

std::uint32_t flatten(Bvh &bvh, const std::vector<BinaryNode> &tree, const Collapse &collapse,
                      std::span<const Triangle> triangles, std::uint32_t first_primitive) {
    return Flattener(bvh, tree, triangles, first_primitive).flatten(collapse);
}

std::uint32_t append_tree(Bvh &bvh, std::span<const Triangle> triangles, std::uint32_t first_primitive) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const std::vector<BinaryNode> tree = build_binary_tree(triangles);
    const auto built = Clock::now();
    const Collapse collapse(tree, bvh.width);
    const auto collapsed = Clock::now();
    const std::uint32_t root = flatten(bvh, tree, collapse, triangles, first_primitive);
    bvh.times.tree += std::chrono::duration<double>(built - start).count();
    bvh.times.collapse += std::chrono::duration<double>(collapsed - built).count();
    bvh.times.flatten += std::chrono::duration<double>(Clock::now() - collapsed).count();
    return root;
}

} // namespace nacre::accel
