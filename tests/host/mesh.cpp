#include "scene/mesh.h"
#include "scene/merge.h"
#include "scene/topology.h"
#include "scene/weld.h"
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace nacre::scene {
namespace {

double volume(const Mesh &mesh) {
    double sum = 0;
    for (const auto &[a, b, c] : mesh.triangles)
        sum += mesh.positions[a].dot(mesh.positions[b].cross(mesh.positions[c])) / 6;
    return sum;
}

bool closed(const Mesh &mesh) {
    const Topology topology = find_topology(mesh);
    return topology.open_edges + topology.non_manifold_edges + topology.inconsistent_edges == 0;
}

Mesh triangle(const Vec3 &a, const Vec3 &b, const Vec3 &c) {
    Mesh mesh;
    mesh.positions = {a, b, c};
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

TEST(Mesh, NormalsGoWithTheInverseTranspose) {
    Mesh mesh = triangle({0, 0, 0}, {1, -1, 0}, {0, 0, 1});
    const float r = std::sqrt(0.5f);
    mesh.normals.assign(3, Vec3f(r, r, 0));
    apply(mesh, Transform(Eigen::Scaling(2.0, 1.0, 1.0)));
    // The plane x + y = 0 becomes x/2 + y = 0.
    const Vec3f expected = Vec3f(0.5f, 1, 0).normalized();
    for (const Vec3f &normal : mesh.normals) EXPECT_LT((normal - expected).norm(), 1e-6);
    EXPECT_EQ(mesh.positions[1], Vec3(2, -1, 0));
}

TEST(Mesh, MirroringKeepsTheOutside) {
    for (const Vec3 &scale : {Vec3(-1, 1, 1), Vec3(-2, -3, -4), Vec3(1, -1, -1)}) {
        Mesh box = make_box({1, 2, 3}, {2, 3, 4});
        apply(box, Transform(Eigen::Scaling(scale)));
        EXPECT_NEAR(volume(box), std::abs(scale.prod()), 1e-12);
        Mesh sphere = make_sphere({0, 0, 0}, 1, 8);
        apply(sphere, Transform(Eigen::Scaling(scale)));
        EXPECT_EQ(count_opposed_normals(sphere), 0u);
    }
}

TEST(Mesh, TinyScalesKeepNormals) {
    Mesh sphere = make_sphere({0, 0, 0}, 1, 8);
    apply(sphere, Transform(Eigen::Scaling(1e-200)));
    for (const Vec3f &normal : sphere.normals) EXPECT_NEAR(normal.norm(), 1, 1e-6);
}

TEST(Mesh, DegenerateTrianglesGoTheirVerticesStay) {
    Mesh mesh;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {0, 0, 0}, {nan, 0, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 0, 1}, {0, 4, 1}, {5, 1, 2}};
    EXPECT_EQ(drop_degenerate(mesh), 4u);
    ASSERT_EQ(mesh.triangles.size(), 1u);
    EXPECT_EQ(mesh.triangles[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
    EXPECT_EQ(mesh.positions.size(), 6u);
}

TEST(Mesh, NeitherOffsetNorScaleMakesDegenerate) {
    for (const double scale : {1e-25, 1.0, 1e25}) {
        Mesh box = make_box({-1, -1, -1}, {1, 1, 1});
        apply(box, Transform(Eigen::Scaling(scale)));
        EXPECT_EQ(drop_degenerate(box), 0u) << scale;
    }
    Mesh far = make_sphere({1e9, 1e9, 1e9}, 1, 64);
    EXPECT_EQ(drop_degenerate(far), 0u);
}

TEST(Mesh, NormalsAreWeightedByAngle) {
    Mesh box = make_box({0, 0, 0}, {1, 1, 1});
    compute_normals(box); // each face's diagonal would show with any other weight
    for (std::size_t i = 0; i < box.positions.size(); ++i) {
        const Vec3f expected = (box.positions[i] - Vec3(0.5, 0.5, 0.5)).normalized().cast<float>();
        EXPECT_LT((box.normals[i] - expected).norm(), 1e-6);
    }
}

TEST(Mesh, NormalsOfSheetsBackToBackAreFinite) {
    Mesh mesh = triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    mesh.triangles.push_back({0, 2, 1});
    mesh.positions.push_back({5, 5, 5}); // of no triangle
    compute_normals(mesh);
    ASSERT_EQ(mesh.normals.size(), 4u);
    for (const Vec3f &normal : mesh.normals) EXPECT_NEAR(normal.norm(), 1, 1e-6);
}

TEST(Mesh, WeldsExactPositionsAndBothZeros) {
    const std::vector<Vec3> positions{{0, 1, 2}, {-0.0, 1, 2}, {1e-300, 1, 2}, {0, 1, 2}};
    EXPECT_EQ(weld(positions), (std::vector<std::uint32_t>{0, 0, 2, 0}));
}

TEST(Mesh, SpheresAreClosedForAnySegments) {
    for (const int segments : {4, 5, 7, 32, 64}) {
        Mesh sphere = make_sphere({1, -2, 3}, 0.5, segments);
        EXPECT_TRUE(closed(sphere)) << segments;
        EXPECT_EQ(find_topology(sphere).shells.size(), 1u);
        EXPECT_EQ(drop_degenerate(sphere), 0u);
        EXPECT_EQ(count_opposed_normals(sphere), 0u);
        EXPECT_EQ(sphere.triangles.size(), std::size_t(2 * segments * (segments / 2 - 1)));
        for (std::size_t i = 0; i < sphere.positions.size(); ++i) {
            const Vec3 radial = (sphere.positions[i] - Vec3(1, -2, 3)) / 0.5;
            EXPECT_LT((radial - sphere.normals[i].cast<double>()).norm(), 1e-6);
            EXPECT_NEAR(sphere.uvs[i].y(), 1 - std::acos(radial.y()) / std::numbers::pi, 1e-3);
        }
    }
    const double ball = 4.0 / 3 * std::numbers::pi;
    EXPECT_NEAR(volume(make_sphere({0, 0, 0}, 1, 256)), ball, 2e-3);
}

TEST(Mesh, UvsOfASphereAreNotMirrored) {
    const Mesh sphere = make_sphere({0, 0, 0}, 1, 32);
    for (const auto &[a, b, c] : sphere.triangles) { // seen from outside, u goes right where v goes up
        const Vec2f ab = sphere.uvs[b] - sphere.uvs[a], ac = sphere.uvs[c] - sphere.uvs[a];
        EXPECT_GT(ab.x() * ac.y() - ab.y() * ac.x(), 0);
    }
}

TEST(Mesh, BoxesAreClosedWithUvsPerFace) {
    const Mesh box = make_box({-1, 0, 2}, {1, 3, 7});
    EXPECT_EQ(box.triangles.size(), 12u);
    EXPECT_TRUE(closed(box));
    EXPECT_NEAR(volume(box), 30, 1e-12);
    ASSERT_EQ(box.uvs.size(), box.positions.size());
    for (const auto &[a, b, c] : box.triangles) {
        const Vec2f ab = box.uvs[b] - box.uvs[a], ac = box.uvs[c] - box.uvs[a];
        EXPECT_EQ(ab.x() * ac.y() - ab.y() * ac.x(), 1); // half a picture, not mirrored
    }
}

TEST(Mesh, AppendGivesEachVertexWhatTheOthersHave) {
    Mesh mesh = make_sphere({0, 0, 0}, 1, 4); // normals and uvs
    const std::size_t before = mesh.triangles.size();
    append(mesh, triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
    EXPECT_EQ(mesh.triangles.size(), before + 1);
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    ASSERT_EQ(mesh.uvs.size(), mesh.positions.size());
    EXPECT_EQ(mesh.normals.back(), Vec3f(0, 0, 1));
    EXPECT_EQ(mesh.positions[mesh.triangles.back()[2]], Vec3(0, 1, 0));
}

} // namespace
} // namespace nacre::scene
