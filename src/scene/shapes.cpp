#include "scene/mesh.h"
#include <cmath>
#include <numbers>

namespace nacre::scene {

Mesh make_sphere(const Vec3 &center, double radius, int segments) {
    const std::uint32_t columns = segments, rows = segments / 2;
    Mesh mesh;
    for (std::uint32_t row = 0; row <= rows; ++row) {
        const double theta = std::numbers::pi * row / rows; // from the north pole, +y
        const double sin_theta = row == 0 || row == rows ? 0 : std::sin(theta);
        const double cos_theta = row == 0 ? 1 : row == rows ? -1 : std::cos(theta);
        for (std::uint32_t column = 0; column <= columns; ++column) {
            // The last column is the first again, to the bit, with u = 1: the seam is closed.
            const double phi = 2 * std::numbers::pi * (column % columns) / columns;
            const Vec3 normal(sin_theta * std::cos(phi), cos_theta, -sin_theta * std::sin(phi));
            const bool pole = row == 0 || row == rows; // a pole's u is that of the middle of its triangle
            mesh.positions.push_back(center + radius * normal);
            mesh.normals.push_back(normal.cast<float>());
            mesh.uvs.emplace_back(static_cast<float>((column + (pole ? 0.5 : 0.0)) / columns),
                                  static_cast<float>(1.0 - static_cast<double>(row) / rows));
        }
    }
    const auto vertex = [&](std::uint32_t row, std::uint32_t column) { return row * (columns + 1) + column; };
    for (std::uint32_t row = 0; row < rows; ++row)
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t a = vertex(row, column), b = vertex(row + 1, column);
            const std::uint32_t c = vertex(row + 1, column + 1), d = vertex(row, column + 1);
            if (row + 1 < rows) mesh.triangles.push_back({a, b, c});               // at the south pole b and c coincide
            if (row > 0) mesh.triangles.push_back({a, row + 1 < rows ? c : b, d}); // at the north pole a and d do
        }
    return mesh;
}

Mesh make_box(const Vec3 &lower, const Vec3 &upper) {
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side) {
            // (axis, s, t) is right-handed on the far side; on the near one s and t change places.
            const int s = side ? (axis + 1) % 3 : (axis + 2) % 3, t = side ? (axis + 2) % 3 : (axis + 1) % 3;
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            for (int corner = 0; corner < 4; ++corner) {
                const bool far_s = corner == 1 || corner == 2, far_t = corner >= 2;
                Vec3 position;
                position[axis] = side ? upper[axis] : lower[axis];
                position[s] = far_s ? upper[s] : lower[s];
                position[t] = far_t ? upper[t] : lower[t];
                mesh.positions.push_back(position);
                mesh.uvs.emplace_back(far_s ? 1.f : 0.f, far_t ? 1.f : 0.f);
            }
            mesh.triangles.push_back({first, first + 1, first + 2});
            mesh.triangles.push_back({first, first + 2, first + 3});
        }
    return mesh;
}

} // namespace nacre::scene
