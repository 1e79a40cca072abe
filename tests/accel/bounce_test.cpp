#include "accel/modes.h"
#include "accel/shapes.h"
#include <gtest/gtest.h>

namespace nacre {
namespace {

/// Secondary rays start at the hit point moved by its error bound: from a convex body, those that leave meet nothing
/// and those that enter meet another triangle.
void expect_clean_bounces(const Shape &shape, const Vec3f &eye_offset) {
    accel::Bvh bvh;
    device::Device device = device::open_device();
    bvh.width = device.quirks.bvh_width;
    const std::uint32_t root = accel::append_tree(bvh, shape.triangles, 0);
    RayProbe probe(device, bvh);
    Random random(9);
    constexpr std::size_t count = 200000;
    std::vector<ProbeRay> rays(count);
    std::vector<Vec3f> directions(count);
    for (std::size_t i = 0; i < count; i++) {
        rays[i].origin = shape.centre + eye_offset * shape.size;
        const Vec3f target = shape.centre + sphere_direction(random) * (0.4f * shape.size * uniform(random));
        rays[i].direction = (target - rays[i].origin).normalized();
        directions[i] = sphere_direction(random);
    }
    std::size_t leave = 0, leave_hit = 0, enter = 0, enter_missed = 0, same = 0;
    for (const ProbeBounce &b : probe.bounce(root, rays, directions)) {
        ASSERT_NE(b.first, BVH_NO_PRIMITIVE);
        const bool hit = b.second != BVH_NO_PRIMITIVE;
        same += hit && b.second == b.first;
        leave += b.cosine > 0;
        enter += b.cosine < 0;
        leave_hit += b.cosine > 0 && hit;
        enter_missed += b.cosine < 0 && !hit;
    }
    EXPECT_GT(leave, count / 4);
    EXPECT_GT(enter, count / 4);
    EXPECT_EQ(same, 0u) << shape.name << " of size " << shape.size;
    EXPECT_EQ(leave_hit, 0u) << shape.name << " of size " << shape.size;
    // Within an error bound of a sharp edge, moving off one face may lead out through the other.
    EXPECT_LE(enter_missed, 2u) << shape.name << " of size " << shape.size;
}

TEST(Bounce, LeavesItsTriangle) {
    const Vec3f outside(1.3f, 0.9f, 1.7f), inside(0.01f, 0.02f, -0.03f);
    // The last one has a face of the cube in the plane y = 0, where the error of a point's own coordinate is 0.
    const Vec3f centres[] = {{0, 0, 0}, {3, -10, 20}, {0, 0.5f, 0}};
    for (const Vec3f &eye : {outside, inside})
        for (const float size : {1e-3f, 1.0f, 1e3f})
            for (const Vec3f &centre : centres) {
                expect_clean_bounces(make_cube(centre * size, size, 3), eye);
                expect_clean_bounces(make_ball(centre * size, size, 64), eye);
            }
}

} // namespace
} // namespace nacre
