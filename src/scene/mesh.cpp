#include "scene/mesh.h"
#include "scene/bounds.h"
#include <limits>

namespace nacre::scene {

void apply(Mesh &mesh, const Transform &transform) {
    // Only directions count below; without this the determinant of a scale of 1e-120 would underflow.
    const double largest = transform.linear().cwiseAbs().maxCoeff();
    const Eigen::Matrix3d linear = largest > 0 ? (transform.linear() / largest).eval() : transform.linear().eval();
    // Normals are covectors: they go with the inverse transpose. The cofactor matrix is det * inverse transpose, so
    // it has the right direction up to the sign of det, and needs no division: flattening transforms are no problem.
    Eigen::Matrix3d cofactor;
    cofactor.col(0) = linear.col(1).cross(linear.col(2));
    cofactor.col(1) = linear.col(2).cross(linear.col(0));
    cofactor.col(2) = linear.col(0).cross(linear.col(1));
    const bool mirrors = linear.determinant() < 0;
    if (mirrors) cofactor = -cofactor;

    for (Vec3 &position : mesh.positions) position = transform * position;
    for (Vec3f &normal : mesh.normals) {
        const Vec3 turned = cofactor * normal.cast<double>();
        normal = turned.stableNormalized().cast<float>();
    }
    if (mirrors)
        for (auto &triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
}

std::size_t drop_degenerate(Mesh &mesh) {
    // The device holds positions as floats relative to the scene's centre and size; the mesh's own box stands for
    // those here, so that neither a far offset nor a small scale makes a good triangle look degenerate.
    Bounds box;
    for (const auto &triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle)
            if (mesh.positions[vertex].allFinite()) box.extend(mesh.positions[vertex]);
    const double size = box.isEmpty() ? 0 : box.sizes().maxCoeff();
    const Vec3 centre = box.isEmpty() ? Vec3(0, 0, 0) : box.center();
    const auto as_float = [&](std::uint32_t vertex) -> Vec3f {
        return ((mesh.positions[vertex] - centre) / size).cast<float>();
    };
    return std::erase_if(mesh.triangles, [&](const std::array<std::uint32_t, 3> &triangle) {
        const Vec3f a = as_float(triangle[0]), b = as_float(triangle[1]), c = as_float(triangle[2]);
        const float squared_area = (b - a).cross(c - a).squaredNorm();
        // Negated so that NaN is dropped too. Below the smallest normal float the normal cannot be normalised.
        return !(squared_area >= std::numeric_limits<float>::min()) || !std::isfinite(squared_area);
    });
}

} // namespace nacre::scene
