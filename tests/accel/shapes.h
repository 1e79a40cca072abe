#pragma once
#include "accel/bvh.h"
#include <random>

namespace nacre {

using Random = std::mt19937;
float uniform(Random &random); // [0, 1)
Vec3f sphere_direction(Random &random);

/// A closed surface: triangles that share corners have equal floats there. Counter-clockwise from outside.
struct Shape {
    std::string name;
    bool convex = true;
    Vec3f centre{0, 0, 0};
    float size = 1; // largest extent, about
    std::vector<accel::Triangle> triangles;
};

// Each is made around `centre`, `size` large, with about 2 n^2 triangles.
Shape make_ball(const Vec3f &centre, float size, int n);
Shape make_cube(const Vec3f &centre, float size, int n);  // axis-aligned: leaf boxes are flat
Shape make_wedge(const Vec3f &centre, float size, int n); // a turned blade, 1/1000 thick at its back, edge 0
Shape make_ring(const Vec3f &centre, float size, int n);  // a bumpy torus: not convex

/// Triangles without order: every ray meets many, most of them grazing some edge.
std::vector<accel::Triangle> make_soup(std::size_t count, std::uint32_t seed);

} // namespace nacre
