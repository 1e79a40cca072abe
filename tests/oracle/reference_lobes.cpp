#include "oracle/reference_lobes.h"
#include <cmath>
#include <numbers>

namespace nacre::reference {
namespace {

using std::numbers::pi;

/// Columns: tangent, bitangent, normal.
Eigen::Matrix3d frame(const Vec3 &normal) {
    Eigen::Matrix3d axes;
    axes.col(2) = normal;
    axes.col(0) = normal.unitOrthogonal();
    axes.col(1) = normal.cross(axes.col(0));
    return axes;
}

Vec3 direction_at(double cosine, Random &random) {
    const double sine = std::sqrt(1 - cosine * cosine), azimuth = 2 * pi * random();
    return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

} // namespace

Vec3 about(const Vec3 &normal, const Vec3 &local) { return frame(normal) * local; }

Vec3 seen_from(const Vec3 &normal, const Vec3 &world) { return frame(normal).transpose() * world; }

Vec3 mirrored(const Vec3 &direction, const Vec3 &geometric) {
    return direction - 2 * direction.dot(geometric) * geometric;
}

Vec3 folded(const Vec3 &direction, const Vec3 &geometric) {
    return direction.dot(geometric) < 0 ? mirrored(direction, geometric) : direction;
}

Vec3 cosine_direction(Random &random) { return direction_at(std::sqrt(random()), random); }

Vec3 uniform_direction(Random &random) { return direction_at(random(), random); }

Vec3 lambert_direction(const Vec3 &shading, const Vec3 &geometric, Random &random) {
    return folded(about(shading, cosine_direction(random)), geometric);
}

double lambert_value(const Vec3 &direction, const Vec3 &shading, const Vec3 &geometric) {
    if (direction.dot(geometric) <= 0) return 0;
    const Vec3 other = mirrored(direction, geometric);
    return (std::max(0.0, direction.dot(shading)) + std::max(0.0, other.dot(shading))) / pi;
}

} // namespace nacre::reference
