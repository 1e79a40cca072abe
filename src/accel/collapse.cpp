#include "accel/collapse.h"
#include <algorithm>
#include <limits>

namespace nacre::accel {
namespace {

float half_area(const Eigen::AlignedBox3f &box) {
    const Vec3f e = box.sizes();
    return e.x() * e.y() + e.y() * e.z() + e.z() * e.x();
}

} // namespace

Collapse::Collapse(const std::vector<BinaryNode> &tree, int width) : tree(tree), width(width), nodes(tree.size()) {
    // A balanced tree needs about 6 entries per triangle.
    costs.reserve(3 * tree.size());
    splits.reserve(3 * tree.size());
    for (std::size_t i = tree.size(); i-- > 0;) decide(static_cast<std::uint32_t>(i));
    costs = {};
}

void Collapse::decide(std::uint32_t index) {
    const BinaryNode &binary = tree[index];
    Node &node = nodes[index];
    node.first = costs.size();
    node.size = static_cast<std::uint8_t>(std::min<std::uint32_t>(binary.count, width));
    costs.resize(node.first + node.size);
    splits.resize(node.first + node.size);

    // Node and block cost the same: each is a handful of vector operations on as many cache lines (measured: 1 : 1 is
    // best).
    const float area = half_area(binary.bounds);
    const std::uint32_t blocks = (binary.count + width - 1) / width;
    const bool fits = blocks <= BVH_LEAF_COUNT_MASK + 1;
    const float as_leaf = area * static_cast<float>(blocks);
    if (binary.leaf()) {
        node.leaf = true;
        costs[node.first] = as_leaf;
        return;
    }

    const Node &left = nodes[binary.child[0]], &right = nodes[binary.child[1]];
    for (int i = 2; i <= node.size; i++)
        costs[node.first + i - 1] = distribute(left, right, i, splits[node.first + i - 1]);
    node.inner = splits[node.first + node.size - 1];
    const float as_node = area + costs[node.first + node.size - 1];
    node.leaf = fits && as_leaf <= as_node;
    costs[node.first] = node.leaf ? as_leaf : as_node;
    for (int i = 2; i <= node.size; i++) {
        const std::size_t entry = node.first + i - 1;
        if (costs[entry] < costs[entry - 1]) continue;
        costs[entry] = costs[entry - 1];
        splits[entry] = splits[entry - 1];
    }
}

float Collapse::distribute(const Node &left, const Node &right, int subtrees, Split &split) const {
    float least = std::numeric_limits<float>::infinity();
    const int begin = std::max(1, subtrees - right.size), end = std::min<int>(left.size, subtrees - 1);
    for (int k = begin; k <= end; k++) {
        const float cost = costs[left.first + k - 1] + costs[right.first + subtrees - k - 1];
        if (k > begin && !(cost < least)) continue;
        least = cost;
        split = {static_cast<std::uint8_t>(k), static_cast<std::uint8_t>(subtrees - k)};
    }
    return least;
}

std::vector<std::uint32_t> Collapse::children(std::uint32_t node) const {
    std::vector<std::uint32_t> out;
    out.reserve(width);
    collect(tree[node].child[0], nodes[node].inner.left, out);
    collect(tree[node].child[1], nodes[node].inner.right, out);
    return out;
}

// Each level has fewer subtrees to hand out, so the recursion is at most `width` deep.
void Collapse::collect(std::uint32_t node, int subtrees, std::vector<std::uint32_t> &out) const {
    const Split split = splits[nodes[node].first + subtrees - 1];
    if (split.left == 0) {
        out.push_back(node);
        return;
    }
    collect(tree[node].child[0], split.left, out);
    collect(tree[node].child[1], split.right, out);
}

} // namespace nacre::accel
