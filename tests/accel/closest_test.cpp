#include "accel/embree_scene.h"
#include "accel/modes.h"
#include "accel/shapes.h"
#include <cmath>
#include <gtest/gtest.h>

namespace nacre {
namespace {

class Closest : public testing::TestWithParam<Mode> {};
INSTANTIATE_TEST_SUITE_P(Modes, Closest, testing::ValuesIn(all_modes),
                         [](const auto &info) { return mode_name(info.param); });

/// Half of the rays are short, as the steps of walks are.
std::vector<ProbeRay> random_rays(std::size_t count, const Vec3f &centre, float size) {
    Random random(7);
    std::vector<ProbeRay> rays(count);
    for (std::size_t i = 0; i < count; i++) {
        const Vec3f offset(uniform(random) - 0.5f, uniform(random) - 0.5f, uniform(random) - 0.5f);
        rays[i].origin = centre + offset * (1.2f * size);
        rays[i].direction = sphere_direction(random);
        if (i % 2) rays[i].t_max = uniform(random) * 0.3f * size;
        if (i % 4 == 3) rays[i].t_min = rays[i].t_max * uniform(random);
    }
    return rays;
}

/// Share of rays whose hits differ from robust Embree's: in being one, or in the distance.
double share_of_different(RayProbe &probe, std::uint32_t root, std::span<const accel::Triangle> triangles,
                          std::span<const ProbeRay> rays, float tolerance) {
    const EmbreeScene scene(triangles, true);
    std::vector<ProbeHit> expected(rays.size());
    scene.closest(rays, expected);
    const std::vector<ProbeHit> hits = probe.closest(root, rays);
    std::size_t different = 0, hit = 0;
    for (std::size_t i = 0; i < rays.size(); i++) {
        hit += expected[i].hit();
        different +=
            hits[i].hit() != expected[i].hit() || (hits[i].hit() && std::abs(hits[i].t - expected[i].t) > tolerance);
    }
    EXPECT_GT(hit, rays.size() / 20) << "the rays must say something";
    return double(different) / double(rays.size());
}

TEST_P(Closest, EqualsEmbreeOnClosedSurfaces) {
    accel::Bvh bvh;
    bvh.width = GetParam().width;
    // Several trees in the same arrays; primitive ids count on.
    std::vector<Shape> shapes{make_ring({0, 0, 0}, 1, 60), make_ball({3, -2, 1}, 2, 40),
                              make_cube({0, 0, 0}, 1e-2f, 30)};
    std::vector<std::uint32_t> roots;
    for (const Shape &shape : shapes) roots.push_back(accel::append_tree(bvh, shape.triangles, 1000));
    RayProbe probe(GetParam().open(), bvh);
    for (std::size_t i = 0; i < shapes.size(); i++) {
        const Shape &s = shapes[i];
        const auto rays = random_rays(100000, s.centre, s.size);
        EXPECT_LE(share_of_different(probe, roots[i], s.triangles, rays, 1e-5f * s.size), 2e-5) << s.name;
    }
}

TEST_P(Closest, EqualsEmbreeInASoup) {
    const auto triangles = make_soup(20000, 5);
    accel::Bvh bvh;
    bvh.width = GetParam().width;
    const std::uint32_t root = accel::append_tree(bvh, triangles, 0);
    RayProbe probe(GetParam().open(), bvh);
    const auto rays = random_rays(100000, {0.5f, 0.5f, 0.5f}, 1);
    EXPECT_LE(share_of_different(probe, root, triangles, rays, 1e-5f), 2e-4); // rays past free edges may differ
}

TEST_P(Closest, NamesTheTriangle) {
    const auto triangles = make_soup(5000, 6);
    accel::Bvh bvh;
    bvh.width = GetParam().width;
    const std::uint32_t root = accel::append_tree(bvh, triangles, 100);
    RayProbe probe(GetParam().open(), bvh);
    const auto rays = random_rays(10000, {0.5f, 0.5f, 0.5f}, 1);
    const auto hits = probe.closest(root, rays);
    std::size_t checked = 0;
    for (std::size_t i = 0; i < rays.size(); i++) {
        if (!hits[i].hit()) continue;
        ASSERT_GE(hits[i].primitive, 100u);
        ASSERT_LT(hits[i].primitive, 5100u);
        const accel::Triangle &triangle = triangles[hits[i].primitive - 100];
        const float *block = bvh.blocks.data() + std::size_t(hits[i].block) * BVH_BLOCK_ROWS * std::size_t(bvh.width);
        for (int k = 0; k < 9; k++) ASSERT_EQ(block[k * bvh.width + int(hits[i].slot)], triangle.v[k / 3][k % 3]);
        const Vec3f normal = (triangle.v[1] - triangle.v[0]).cross(triangle.v[2] - triangle.v[0]).normalized();
        const Vec3f p = rays[i].origin + rays[i].direction * hits[i].t;
        const float height = std::abs(normal.dot(p - triangle.v[0]));
        ASSERT_LT(height, 1e-5f);
        checked++;
    }
    EXPECT_GT(checked, 1000u);
}

TEST_P(Closest, AnyHitsWhereClosestDoes) {
    const auto triangles = make_soup(2000, 8);
    accel::Bvh bvh;
    bvh.width = GetParam().width;
    const std::uint32_t root = accel::append_tree(bvh, triangles, 0);
    RayProbe probe(GetParam().open(), bvh);
    const auto rays = random_rays(100000, {0.5f, 0.5f, 0.5f}, 1);
    const auto hits = probe.closest(root, rays);
    const auto any = probe.any(root, rays);
    std::size_t different = 0;
    for (std::size_t i = 0; i < rays.size(); i++) different += (any[i] != 0) != hits[i].hit();
    EXPECT_LE(different, 2u); // a hit at t_min or t_max to the last bit
}

TEST_P(Closest, HitsFromBothSidesBetweenTheLimits) {
    const accel::Triangle triangle{{Vec3f(-1, -1, 0), Vec3f(1, -1, 0), Vec3f(0, 1, 0)}};
    accel::Bvh bvh;
    bvh.width = GetParam().width;
    const std::uint32_t root = accel::append_tree(bvh, {&triangle, 1}, 42);
    RayProbe probe(GetParam().open(), bvh);
    for (const float side : {1.0f, -1.0f}) {
        const Vec3f origin(0.1f, -0.2f, side), down(0, 0, -side);
        const std::vector<ProbeRay> rays{{origin, 1e30f, down, 0},
                                         {origin, 1.0f, down, 0},    // t_max counts as inside
                                         {origin, 0.999f, down, 0},  // too short
                                         {origin, 2.0f, down, 1.0f}, // t_min does not
                                         {origin, 2.0f, down, 0.999f},
                                         {origin, 1e30f, -down, 0},
                                         {origin, std::numeric_limits<float>::infinity(), down, 0},
                                         {origin, 2.0f, down * 0.5f, 0}}; // t counts lengths of the direction
        const bool expected[] = {true, true, false, false, true, false, true, true};
        const auto hits = probe.closest(root, rays);
        const auto any = probe.any(root, rays);
        for (std::size_t i = 0; i < rays.size(); i++) {
            EXPECT_EQ(hits[i].hit(), expected[i]) << i;
            EXPECT_EQ(any[i] != 0, expected[i]) << i;
            if (!hits[i].hit()) continue;
            EXPECT_EQ(hits[i].primitive, 42u);
            EXPECT_FLOAT_EQ(hits[i].t, i == 7 ? 2.0f : 1.0f);
        }
    }
}

} // namespace
} // namespace nacre
