#pragma once
#include "accel/bvh.h"
#include <random>

namespace nacre::bench {

using Random = std::mt19937;

/// In [0, 1), a multiple of 2^-24.
float uniform(Random &random);

Vec3f sphere_direction(Random &random);

/// Cosine-weighted around the unit vector n.
Vec3f cosine_direction(Random &random, const Vec3f &n);

/// Unit, on the counter-clockwise side.
Vec3f triangle_normal(const accel::Triangle &triangle);

/// Where walks enter a surface: in clusters of 400 over a few hundred neighbouring triangles, as the pixels of a tile
/// do.
class Entries {
  public:
    struct Entry {
        Vec3f position, normal; // on a triangle; its unit normal
        Vec3f direction;        // inwards, cosine-weighted
    };

    explicit Entries(std::span<const accel::Triangle> triangles) : triangles(triangles) {}

    Entry next(Random &random);

  private:
    const std::span<const accel::Triangle> triangles;
    std::size_t cluster = 0, count = 0;
};

} // namespace nacre::bench
