#include "oracle/reference_normal.h"
#include "oracle/reference_texture.h"
#include <cmath>

namespace nacre::reference {

Vec3 mapped_normal(const scene::Scene &scene, std::uint32_t index, const Vec2 &uv, const Vec3 &normal,
                   const Triangle &triangle, const std::array<Vec2, 3> &corners) {
    const Vec2 &scale = scene.textures[index].scale;
    Eigen::Matrix2d steps; // of the picture's coordinates along two edges
    steps << (corners[1] - corners[0]).cwiseProduct(scale), (corners[2] - corners[0]).cwiseProduct(scale);
    if (steps.determinant() == 0) return normal;
    Eigen::Matrix<double, 3, 2> edges;
    edges << triangle[1] - triangle[0], triangle[2] - triangle[0];
    const Eigen::Matrix<double, 3, 2> gradient = edges * steps.inverse(); // of position by u, v
    const Vec3 tangent = (gradient.col(0) - normal.dot(gradient.col(0)) * normal).normalized();
    const Vec3 bitangent = normal.cross(tangent) * std::copysign(1.0, steps.determinant());
    const Vec3 map = 2 * texture_at(scene, index, uv) - Vec3::Ones();
    return (map.x() * tangent + map.y() * bitangent + map.z() * normal).normalized();
}

} // namespace nacre::reference
