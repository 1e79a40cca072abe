#include "accel/bvh.h"
#include "accel/shapes.h"
#include <algorithm>
#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace nacre {
namespace {

/// Reads a flattened tree back, knowing nothing but kernels/shared/bvh.h.
class Reader {
  public:
    Reader(const accel::Bvh &bvh, std::span<const accel::Triangle> triangles, std::uint32_t first)
        : bvh(bvh), triangles(triangles), first(first), width(std::size_t(bvh.width)), seen(triangles.size()) {}

    /// Every triangle once, inside all the boxes above it. Returns the deepest stack.
    std::uint32_t read(std::uint32_t root) {
        const float inf = std::numeric_limits<float>::infinity();
        visit(root, Eigen::AlignedBox3f(Vec3f::Constant(-inf), Vec3f::Constant(inf)), 0);
        return deepest;
    }
    std::size_t missing() const { return std::size_t(std::count(seen.begin(), seen.end(), 0)); }
    std::size_t repeated() const {
        return std::size_t(std::count_if(seen.begin(), seen.end(), [](int n) { return n > 1; }));
    }
    float extent(std::uint32_t node) const { return nodes(node, BVH_ROW_EXTENT, 0); }

  private:
    float nodes(std::uint32_t node, std::size_t row, std::size_t slot) const {
        return bvh.nodes.at((std::size_t(node) * BVH_NODE_ROWS + row) * width + slot);
    }
    float blocks(std::uint32_t block, std::size_t row, std::size_t slot) const {
        return bvh.blocks.at((std::size_t(block) * BVH_BLOCK_ROWS + row) * width + slot);
    }

    void visit(std::uint32_t child, const Eigen::AlignedBox3f &box, std::uint32_t pushed) {
        deepest = std::max(deepest, pushed);
        if (child & BVH_LEAF_BIT) return visit_leaf(child, box);
        std::vector<std::pair<std::uint32_t, Eigen::AlignedBox3f>> children;
        for (std::size_t slot = 0; slot < width; slot++) {
            const Vec3f lower(nodes(child, 0, slot), nodes(child, 2, slot), nodes(child, 4, slot));
            const Vec3f upper(nodes(child, 1, slot), nodes(child, 3, slot), nodes(child, 5, slot));
            if (lower.x() == BVH_EMPTY) {
                EXPECT_TRUE(lower == Vec3f::Constant(BVH_EMPTY) && upper == -lower);
                continue;
            }
            children.push_back({std::bit_cast<std::uint32_t>(nodes(child, BVH_ROW_CHILD, slot)), {lower, upper}});
            EXPECT_TRUE(box.contains(children.back().second));
        }
        EXPECT_GE(children.size(), 2u);
        for (const auto &[next, inner] : children) visit(next, inner, pushed + std::uint32_t(children.size()) - 1);
    }

    void visit_leaf(std::uint32_t leaf, const Eigen::AlignedBox3f &box) {
        const std::uint32_t begin = leaf & BVH_LEAF_FIRST_MASK;
        const std::uint32_t count = (leaf >> BVH_LEAF_COUNT_SHIFT & BVH_LEAF_COUNT_MASK) + 1;
        for (std::uint32_t block = begin; block < begin + count; block++)
            for (std::size_t slot = 0; slot < width; slot++) {
                const auto primitive = std::bit_cast<std::uint32_t>(blocks(block, BVH_ROW_PRIMITIVE, slot));
                if (primitive == BVH_NO_PRIMITIVE) {
                    for (std::size_t row = 0; row < 9; row++) EXPECT_EQ(blocks(block, row, slot), 0);
                    continue;
                }
                seen.at(primitive - first)++;
                for (int k = 0; k < 3; k++) {
                    const auto row = std::size_t(3 * k);
                    const Vec3f v(blocks(block, row, slot), blocks(block, row + 1, slot), blocks(block, row + 2, slot));
                    EXPECT_EQ(v, triangles[primitive - first].v[k]);
                    EXPECT_TRUE(box.contains(v));
                }
            }
    }

    const accel::Bvh &bvh;
    const std::span<const accel::Triangle> triangles;
    const std::uint32_t first;
    const std::size_t width;
    std::vector<int> seen;
    std::uint32_t deepest = 0;
};

void expect_sound(int width, std::span<const accel::Triangle> triangles) {
    accel::Bvh bvh;
    bvh.width = width;
    // Behind another tree, so that nothing may count from 0.
    const auto before = make_ball({0, 0, 0}, 1, 4).triangles;
    accel::append_tree(bvh, before, 0);
    bvh.stack = 0;
    const std::uint32_t root = accel::append_tree(bvh, triangles, 32);
    Reader reader(bvh, triangles, 32);
    EXPECT_EQ(reader.read(root), bvh.stack);
    EXPECT_EQ(reader.missing(), 0u);
    EXPECT_EQ(reader.repeated(), 0u);
    EXPECT_EQ(bvh.nodes.size() % (BVH_NODE_ROWS * std::size_t(width)), 0u);
    EXPECT_EQ(bvh.blocks.size() % (BVH_BLOCK_ROWS * std::size_t(width)), 0u);
    if (root & BVH_LEAF_BIT) return;
    float extent = 0;
    for (const auto &t : triangles)
        for (const Vec3f &v : t.v) extent = std::max(extent, v.cwiseAbs().maxCoeff());
    EXPECT_EQ(reader.extent(root), extent);
}

class Build : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Width, Build, testing::Values(4, 8, 16));

TEST_P(Build, HoldsEveryTriangleOnce) {
    for (const int n : {1, 2, 3, 7, 16, 17, 129, 1000}) expect_sound(GetParam(), make_soup(std::size_t(n), 11));
    expect_sound(GetParam(), make_ring({5, 0, 0}, 1, 80).triangles);
    expect_sound(GetParam(), make_cube({0, 0, 0}, 1, 60).triangles);
}

TEST_P(Build, EqualTriangles) {
    const accel::Triangle triangle{{Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)}};
    expect_sound(GetParam(), std::vector<accel::Triangle>(10000, triangle));
}

/// Each triangle twice as large as the one before: the tree that surface areas ask for is as deep as it is long.
TEST_P(Build, DeepTree) {
    std::vector<accel::Triangle> triangles;
    for (int k = -60; k < 60; k++) {
        const float s = std::ldexp(1.0f, k / 2);
        for (int i = 0; i < 5; i++) triangles.push_back({Vec3f(s, 0, 0), Vec3f(s * 1.1f, s, 0), Vec3f(s, 0, s)});
    }
    expect_sound(GetParam(), triangles);
}

TEST(Build, EmptyTreeHasARoot) {
    accel::Bvh bvh;
    const std::uint32_t root = accel::append_tree(bvh, {}, 0);
    EXPECT_EQ(root, 0u);
    EXPECT_EQ(bvh.nodes.size(), 128u);
    for (std::size_t i = 0; i < 96; i++) EXPECT_EQ(bvh.nodes[i], i / 16 % 2 ? -BVH_EMPTY : BVH_EMPTY);
}

} // namespace
} // namespace nacre
