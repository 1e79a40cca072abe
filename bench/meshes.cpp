#include "meshes.h"
#include <cmath>
#include <numbers>

namespace nacre::bench {
namespace {

/// -1..1, at a corner of the unit lattice. Teschner et al. 2003, "Optimized Spatial Hashing", mixed further.
double lattice(int x, int y, int z) {
    std::uint32_t h = std::uint32_t(x) * 73856093u ^ std::uint32_t(y) * 19349663u ^ std::uint32_t(z) * 83492791u;
    h = (h ^ (h >> 13)) * 0x5bd1e995u;
    h = (h ^ (h >> 15)) * 0x27d4eb2du;
    h ^= h >> 13;
    return h * (2.0 / 4294967295.0) - 1;
}

/// Value noise: lattice values, interpolated with a continuous second derivative.
double noise(const Vec3 &p) {
    const Vec3 base = p.array().floor(), f = p - base;
    const Vec3 s = f.unaryExpr([](double t) { return t * t * t * (t * (t * 6 - 15) + 10); });
    double sum = 0;
    for (int corner = 0; corner < 8; corner++) {
        const int i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
        const double weight = (i ? s.x() : 1 - s.x()) * (j ? s.y() : 1 - s.y()) * (k ? s.z() : 1 - s.z());
        sum += weight * lattice(int(base.x()) + i, int(base.y()) + j, int(base.z()) + k);
    }
    return sum;
}

Vec3 to_float(const Vec3 &p) { return p.cast<float>().cast<double>(); }

void add_quad(scene::Mesh &mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
}

Vec3 blob_point(const Vec3 &direction) {
    double radius = 1 + 0.30 * noise(direction * 1.7 + Vec3(5, 7, 9));
    radius += 0.08 * noise(direction * 6) + 0.03 * noise(direction * 17) + 0.010 * noise(direction * 45);
    return direction * (radius + 0.003 * noise(direction * 120));
}

} // namespace

scene::Mesh make_blob(int side) {
    scene::Mesh mesh;
    for (int face = 0; face < 6; face++) {
        const auto base = std::uint32_t(mesh.positions.size()), row = std::uint32_t(side + 1);
        const int axis = face / 2;
        const double sign = face % 2 ? -1 : 1;
        for (int j = 0; j <= side; j++)
            for (int i = 0; i <= side; i++) {
                const double a = 2.0 * i / side - 1, b = 2.0 * j / side - 1;
                Vec3 p;
                p[axis] = sign;
                p[(axis + 1) % 3] = face % 2 ? b : a; // swapped on the far side: all faces are counter-clockwise
                p[(axis + 2) % 3] = face % 2 ? a : b;
                mesh.positions.push_back(to_float(blob_point(p.normalized())));
            }
        for (std::uint32_t j = 0; j < row - 1; j++)
            for (std::uint32_t i = 0; i < row - 1; i++) {
                const std::uint32_t corner = base + j * row + i;
                add_quad(mesh, corner, corner + 1, corner + row + 1, corner + row);
            }
    }
    return mesh;
}

scene::Mesh make_knot(int around) {
    constexpr double turn = 2 * std::numbers::pi;
    const int along = 8 * around;
    const auto centre = [](double t) {
        const double r = 0.65 + 0.25 * std::cos(3 * t);
        return Vec3(r * std::cos(2 * t), r * std::sin(2 * t), -0.35 * std::sin(3 * t));
    };
    scene::Mesh mesh;
    for (int i = 0; i < along; i++) {
        const double t = turn * i / along;
        const Vec3 c = centre(t), tangent = (centre(t + 1e-3) - centre(t - 1e-3)).normalized();
        const Vec3 binormal = tangent.cross(c.normalized()).normalized(), normal = binormal.cross(tangent);
        for (int j = 0; j < around; j++) {
            const double a = turn * j / around;
            const Vec3 direction = normal * std::cos(a) + binormal * std::sin(a), p = c + direction * 0.14;
            const double radius = 0.14 + 0.02 * noise(p * 12) + 0.006 * noise(p * 50) + 0.002 * noise(p * 150);
            mesh.positions.push_back(to_float(c + direction * radius));
        }
    }
    const auto index = [&](int i, int j) { return std::uint32_t(i % along * around + j % around); };
    for (int i = 0; i < along; i++)
        for (int j = 0; j < around; j++)
            add_quad(mesh, index(i, j), index(i, j + 1), index(i + 1, j + 1), index(i + 1, j));
    return mesh;
}

} // namespace nacre::bench
