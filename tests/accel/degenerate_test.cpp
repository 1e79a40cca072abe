#include "accel/modes.h"
#include "accel/shapes.h"
#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace nacre {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

class Degenerate : public testing::TestWithParam<Mode> {
  protected:
    Degenerate() { bvh.width = GetParam().width; }
    std::vector<ProbeHit> trace(std::span<const accel::Triangle> triangles, std::span<const ProbeRay> rays) {
        const std::uint32_t root = accel::append_tree(bvh, triangles, 0);
        return RayProbe(GetParam().open(), bvh).closest(root, rays);
    }
    accel::Bvh bvh;
};
INSTANTIATE_TEST_SUITE_P(Modes, Degenerate, testing::ValuesIn(all_modes),
                         [](const auto &info) { return mode_name(info.param); });

const accel::Triangle upright{{Vec3f(-1, -1, 0), Vec3f(1, -1, 0), Vec3f(0, 1, 0)}};

TEST_P(Degenerate, NothingIsHitInAnEmptyTree) {
    std::vector<ProbeRay> rays;
    Random random(1);
    for (int i = 0; i < 1000; i++) rays.push_back({sphere_direction(random), infinity, sphere_direction(random), 0});
    rays.push_back({{0, 0, 0}, infinity, {1, 0, 0}, 0});
    rays.push_back({{0, 0, 0}, infinity, {0, -0.0f, -1}, 0});
    for (const ProbeHit &hit : trace({}, rays)) EXPECT_FALSE(hit.hit());
}

TEST_P(Degenerate, TriangleWithoutAreaIsNeverHit) {
    const Vec3f a(-1, 0, 0), b(1, 0, 0), middle(0, 0, 0), up(0, 1, 0);
    const std::vector<accel::Triangle> triangles{{a, b, middle}, {a, a, b}, {a, a, a}, {up, up, b}, {middle, a, b}};
    std::vector<ProbeRay> rays;
    Random random(2);
    for (int i = 0; i < 10000; i++) {
        const Vec3f origin = sphere_direction(random) * 2, target = a + (b - a) * uniform(random);
        rays.push_back({origin, infinity, (target - origin).normalized(), 0});
    }
    rays.push_back({{0, 0, 2}, infinity, {0, 0, -1}, 0});
    rays.push_back({{-3, 0, 0}, infinity, {1, 0, 0}, 0}); // along it
    for (const ProbeHit &hit : trace(triangles, rays)) EXPECT_FALSE(hit.hit());
}

TEST_P(Degenerate, TenThousandEqualTriangles) {
    const std::vector<accel::Triangle> triangles(10000, upright);
    const std::vector<ProbeRay> rays(64, {{0.1f, 0.1f, 1}, infinity, {0, 0, -1}, 0});
    const std::uint32_t root = accel::append_tree(bvh, triangles, 0);
    // With a stack of exactly the size that the tree says, and with plenty: every box is entered at once.
    for (const std::uint32_t stack : {std::max(bvh.stack, 1u), 1024u})
        for (const ProbeHit &hit : RayProbe(GetParam().open(), bvh, {}, stack).closest(root, rays)) {
            ASSERT_TRUE(hit.hit());
            ASSERT_EQ(hit.t, 1.0f);
            ASSERT_LT(hit.primitive, 10000u);
        }
}

TEST_P(Degenerate, RaysThatAreNone) {
    const std::vector<ProbeRay> rays{{{0, 0, 1}, infinity, {0, 0, 0}, 0},
                                     {{0, 0, 1}, infinity, {nan, 0, -1}, 0},
                                     {{0, 0, 1}, infinity, {nan, nan, nan}, 0},
                                     {{0, 0, 1}, infinity, {0, 0, -infinity}, 0},
                                     {{nan, 0, 1}, infinity, {0, 0, -1}, 0},
                                     {{0, 0, infinity}, infinity, {0, 0, -1}, 0},
                                     {{infinity, infinity, infinity}, infinity, {-1, -1, -1}, 0},
                                     {{0, 0, 1}, nan, {0, 0, -1}, 0},
                                     {{0, 0, 1}, infinity, {0, 0, -1}, nan},
                                     {{0, 0, 1}, 0, {0, 0, -1}, 0},
                                     {{0, 0, 1}, -1, {0, 0, -1}, 0}};
    const auto triangles = make_soup(1000, 3); // a tree with nodes
    for (const ProbeHit &hit : trace(triangles, rays)) EXPECT_FALSE(hit.hit());
    for (const ProbeHit &hit : trace({&upright, 1}, rays)) EXPECT_FALSE(hit.hit());
}

TEST_P(Degenerate, TrianglesThatAreNotFiniteAreLeftOut) {
    std::vector<accel::Triangle> triangles = make_ball({0, 0, 0}, 1, 20).triangles;
    const std::size_t good = triangles.size();
    triangles.push_back({Vec3f(nan, 0, 0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)});
    triangles.push_back({Vec3f(0, 0, 0), Vec3f(infinity, 0, 0), Vec3f(0, 1, 0)});
    Random random(4);
    std::vector<ProbeRay> rays;
    for (int i = 0; i < 1000; i++) rays.push_back({{0, 0, 0}, infinity, sphere_direction(random), 0});
    for (const ProbeHit &hit : trace(triangles, rays)) {
        ASSERT_TRUE(hit.hit());
        ASSERT_LT(hit.primitive, good);
    }
}

/// Along the axes, with zeros of both signs, from origins that lie exactly in the planes of the boxes.
TEST_P(Degenerate, RaysAlongAxesAndInPlanesOfBoxes) {
    const Shape cube = make_cube({0, 0, 0}, 2, 24); // lattice of 1/4
    std::vector<ProbeRay> rays;
    for (int axis = 0; axis < 3; axis++)
        for (int sign = -1; sign <= 1; sign += 2)
            for (int i = -4; i <= 4; i++)
                for (int j = -4; j <= 4; j++)
                    for (int zero = 0; zero < 4; zero++) {
                        ProbeRay ray;
                        ray.origin[axis] = 0.125f;
                        ray.origin[(axis + 1) % 3] = float(i) / 4;
                        ray.origin[(axis + 2) % 3] = float(j) / 4;
                        ray.direction[axis] = float(sign);
                        ray.direction[(axis + 1) % 3] = zero & 1 ? -0.0f : 0.0f;
                        ray.direction[(axis + 2) % 3] = zero & 2 ? -0.0f : 0.0f;
                        rays.push_back(ray);
                    }
    const auto hits = trace(cube.triangles, rays);
    for (std::size_t i = 0; i < rays.size(); i++) {
        ASSERT_TRUE(hits[i].hit()) << rays[i].origin.transpose() << " towards " << rays[i].direction.transpose();
        ASSERT_LE(hits[i].t, 1.125f); // in the plane of a face, its sides are met at the rim
    }
}

} // namespace
} // namespace nacre
