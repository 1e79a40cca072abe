#include "scene/mesh.h"
#include "scene/weld.h"
#include <cmath>

namespace nacre::scene {

namespace {

// The angle at `corner` of a triangle. atan2 keeps its accuracy near 0 and pi, where acos does not.
double angle_at(const Vec3 &corner, const Vec3 &next, const Vec3 &previous) {
    const Vec3 a = next - corner, b = previous - corner;
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

} // namespace

// Angle weights (Thürmer and Wüthrich, "Computing vertex normals from polygonal facets", 1998): the result does not
// depend on how a face is cut into triangles.
void compute_normals(Mesh &mesh) {
    const std::vector<std::uint32_t> first = weld(mesh.positions);
    std::vector<Vec3> sums(mesh.positions.size(), Vec3::Zero());
    std::vector<Vec3> faces(mesh.positions.size(), Vec3::Zero()); // any face of the vertex: for sums that cancel
    for (const auto &triangle : mesh.triangles) {
        const Vec3 &a = mesh.positions[triangle[0]], &b = mesh.positions[triangle[1]], &c = mesh.positions[triangle[2]];
        const Vec3 face = (b - a).cross(c - a).stableNormalized();
        const double angles[3] = {angle_at(a, b, c), angle_at(b, c, a), angle_at(c, a, b)};
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = first[triangle[corner]];
            sums[vertex] += angles[corner] * face;
            faces[vertex] = face;
        }
    }
    mesh.normals.resize(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3 &sum = sums[first[i]], &face = faces[first[i]];
        // Two sheets back to back cancel to rounding noise: a face normal is then at least a normal of the surface.
        const Vec3 normal = sum.norm() > 1e-6 ? sum.normalized() : face;
        mesh.normals[i] = normal.isZero() ? Vec3f(0, 0, 1) : Vec3f(normal.cast<float>()); // no triangle uses it
    }
}

} // namespace nacre::scene
