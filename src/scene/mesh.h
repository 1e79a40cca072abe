#pragma once
#include "base/vector.h"
#include <array>
#include <cstdint>
#include <vector>

namespace nacre::scene {

/// Triangles in world space, scene units. Counter-clockwise seen from outside.
struct Mesh {
    std::vector<Vec3> positions;
    std::vector<Vec3f> normals; // one per position, unit; empty: geometric normals
    std::vector<Vec2f> uvs;     // one per position, v up (0 at the bottom of the picture); empty: none
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Bakes scale, rotation and translation into positions and normals; turns triangles round if it mirrors.
void apply(Mesh &mesh, const Transform &transform);

/// Drops triangles without area (in float) and returns how many. Their vertices stay.
std::size_t drop_degenerate(Mesh &mesh);

/// Normals averaged over the triangles of each position (positions that coincide are one), weighted by angle.
void compute_normals(Mesh &mesh);

/// A sphere of `segments` x `segments`/2 quads, with normals and latitude-longitude uvs. segments >= 4.
Mesh make_sphere(const Vec3 &center, double radius, int segments);

/// An axis-aligned box of 12 triangles, geometric normals, each face with uvs 0..1.
Mesh make_box(const Vec3 &lower, const Vec3 &upper);

} // namespace nacre::scene
