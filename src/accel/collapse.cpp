#include "accel/collapse.h"
#include "base/parallel.h"
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
    std::size_t entries = 0; // a balanced tree needs about 6 per triangle
    std::vector<std::uint32_t> subtrees, above;
    for (std::uint32_t i = 0, begun = 0; i < tree.size(); i++) {
        nodes[i].first = entries;
        nodes[i].size = static_cast<std::uint8_t>(std::min<std::uint32_t>(tree[i].count, width));
        entries += nodes[i].size;
        if (i < begun) continue; // inside the last subtree
        if (tree[i].count > subtree_grain) {
            above.push_back(i);
        } else {
            subtrees.push_back(i);
            begun = i + 2 * tree[i].count - 1;
        }
    }
    costs.resize(entries);
    splits.resize(entries);
    parallel_for(subtrees.size(), [&](std::size_t subtree) {
        const std::uint32_t root = subtrees[subtree];
        for (std::uint32_t i = root + 2 * tree[root].count - 1; i-- > root;) decide(i);
    });
    for (std::size_t i = above.size(); i-- > 0;) decide(above[i]);
    costs = {};
}

void Collapse::decide(std::uint32_t index) {
    const BinaryNode &binary = tree[index];
    Node &node = nodes[index];

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
