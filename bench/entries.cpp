#include "entries.h"
#include <cmath>
#include <numbers>

namespace nacre::bench {

float uniform(Random &random) { return float(random() >> 8) * 0x1p-24f; }

Vec3f sphere_direction(Random &random) {
    const float z = 1 - 2 * uniform(random), phi = 2 * std::numbers::pi_v<float> * uniform(random);
    const float r = std::sqrt(std::max(0.0f, 1 - z * z));
    return {r * std::cos(phi), r * std::sin(phi), z};
}

Vec3f cosine_direction(Random &random, const Vec3f &n) {
    const Vec3f d = n + sphere_direction(random);
    return d.squaredNorm() > 1e-8f ? d.normalized() : n;
}

Vec3f triangle_normal(const accel::Triangle &triangle) {
    const Vec3f &a = triangle.v[0];
    return (triangle.v[1] - a).cross(triangle.v[2] - a).normalized();
}

Entries::Entry Entries::next(Random &random) {
    if (count++ % 400 == 0) cluster = random() % triangles.size();
    const accel::Triangle &triangle = triangles[(cluster + random() % 256) % triangles.size()];
    const float s = std::sqrt(uniform(random)), b = s * uniform(random);
    Entry entry;
    entry.normal = triangle_normal(triangle);
    entry.position = triangle.v[0] * (1 - s) + triangle.v[1] * (s - b) + triangle.v[2] * b;
    entry.direction = cosine_direction(random, -entry.normal);
    return entry;
}

} // namespace nacre::bench
