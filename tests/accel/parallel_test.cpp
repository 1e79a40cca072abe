#include "accel/collapse.h"
#include "accel/shapes.h"
#include "base/parallel.h"
#include <cstring>
#include <gtest/gtest.h>
#include <sched.h>
#include <stdexcept>

namespace nacre {
namespace {

/// While it lives, this thread may use one core only, and parallel_for starts no other.
class OneCore {
  public:
    OneCore() {
        sched_getaffinity(0, sizeof before, &before);
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(sched_getcpu(), &one);
        sched_setaffinity(0, sizeof one, &one);
    }
    ~OneCore() { sched_setaffinity(0, sizeof before, &before); }

  private:
    cpu_set_t before;
};

TEST(Parallel, CallsEachOnce) {
    for (const std::size_t count : {0, 1, 2, 3, 1000}) {
        std::vector<std::atomic<int>> calls(count);
        parallel_for(count, [&](std::size_t i) { calls[i]++; });
        for (const auto &n : calls) EXPECT_EQ(n, 1);
    }
}

TEST(Parallel, ThrowsWhatACallThrows) {
    std::atomic<int> calls{0};
    const auto fail_early = [&](std::size_t i) {
        calls++;
        if (i == 3) throw std::runtime_error("the fourth");
    };
    EXPECT_THROW(parallel_for(1000000, fail_early), std::runtime_error);
    EXPECT_LT(calls, 1000000);
}

/// Nodes in the order that collapse and flatten share their work by.
TEST(Parallel, BinaryTreeIsDepthFirst) {
    const auto ring = make_ring({0, 0, 0}, 1, 100).triangles; // larger than some subtree_grain
    const auto tree = accel::build_binary_tree(ring);
    ASSERT_EQ(tree.size(), 2 * ring.size() - 1);
    ASSERT_EQ(tree[0].count, ring.size());
    std::vector<int> seen(ring.size());
    for (std::uint32_t i = 0; i < tree.size(); i++) {
        if (tree[i].leaf()) {
            seen[tree[i].triangle]++;
            for (const Vec3f &v : ring[tree[i].triangle].v) ASSERT_TRUE(tree[i].bounds.contains(v));
            continue;
        }
        const accel::BinaryNode &left = tree[tree[i].child[0]], &right = tree[tree[i].child[1]];
        ASSERT_EQ(tree[i].child[0], i + 1);
        ASSERT_EQ(tree[i].child[1], i + 2 * left.count);
        ASSERT_EQ(tree[i].count, left.count + right.count);
        ASSERT_TRUE(tree[i].bounds.contains(left.bounds) && tree[i].bounds.contains(right.bounds));
    }
    EXPECT_EQ(seen, std::vector<int>(ring.size(), 1));
}

/// One core and all of them make one tree.
TEST(Parallel, CoresDoNotChangeTheTree) {
    const auto ring = make_ring({0, 0, 0}, 1, 150).triangles;
    const auto soup = make_soup(20000, 7);
    for (const auto &triangles : {ring, soup}) {
        const auto tree = accel::build_binary_tree(triangles);
        const auto flattened = [&] {
            accel::Bvh bvh;
            accel::flatten(bvh, tree, accel::Collapse(tree, bvh.width), triangles, 0);
            return bvh;
        };
        const accel::Bvh all = flattened();
        const OneCore pinned;
        ASSERT_EQ(usable_cores(), 1u);
        const accel::Bvh one = flattened();
        EXPECT_EQ(one.stack, all.stack);
        // By bits: some of the floats are indices.
        ASSERT_EQ(one.nodes.size(), all.nodes.size());
        ASSERT_EQ(one.blocks.size(), all.blocks.size());
        EXPECT_EQ(std::memcmp(one.nodes.data(), all.nodes.data(), one.nodes.size() * sizeof(float)), 0);
        EXPECT_EQ(std::memcmp(one.blocks.data(), all.blocks.data(), one.blocks.size() * sizeof(float)), 0);
    }
}

} // namespace
} // namespace nacre
