#include "accel/shapes.h"
#include <cmath>
#include <functional>
#include <numbers>

namespace nacre {
namespace {

constexpr double turn = 2 * std::numbers::pi;

/// Grid of (rows + 1) x columns points, columns wrap round: `at` must give one point for a whole row that is a pole.
void add_grid(Shape &shape, int rows, int columns, const std::function<Vec3(int, int)> &at) {
    const auto point = [&](int i, int j) -> Vec3f {
        return shape.centre + (at(i, j % columns) * double(shape.size)).cast<float>();
    };
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++) {
            const Vec3f a = point(i, j), b = point(i + 1, j), c = point(i + 1, j + 1), d = point(i, j + 1);
            if (b != c) shape.triangles.push_back({a, b, c});
            if (a != d) shape.triangles.push_back({a, c, d});
        }
}

} // namespace

float uniform(Random &random) { return float(random() >> 8) * 0x1p-24f; }

Vec3f sphere_direction(Random &random) {
    const float z = 1 - 2 * uniform(random), phi = float(turn) * uniform(random);
    const float r = std::sqrt(std::max(0.0f, 1 - z * z));
    return {r * std::cos(phi), r * std::sin(phi), z};
}

Shape make_ball(const Vec3f &centre, float size, int n) {
    Shape shape{"ball", true, centre, size, {}};
    add_grid(shape, n, n, [&](int i, int j) -> Vec3 {
        if (i == 0) return {0, 0.5, 0};
        if (i == n) return {0, -0.5, 0};
        const double theta = turn / 2 * i / n, phi = turn * j / n;
        return 0.5 * Vec3(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi));
    });
    return shape;
}

Shape make_cube(const Vec3f &centre, float size, int n) {
    Shape shape{"cube", true, centre, size, {}};
    const int side = std::max(1, n / 3);
    // Points lie on a lattice, so that faces meet in equal floats.
    const auto lattice = [&](int k) { return double(k) / side - 0.5; };
    for (int axis = 0; axis < 3; axis++)
        for (int far = 0; far < 2; far++)
            for (int i = 0; i < side; i++)
                for (int j = 0; j < side; j++) {
                    const auto corner = [&](int a, int b) -> Vec3f {
                        Vec3 p;
                        p[axis] = lattice(far * side);
                        p[(axis + 1) % 3] = lattice(far ? a : b);
                        p[(axis + 2) % 3] = lattice(far ? b : a);
                        return centre + (p * double(size)).cast<float>();
                    };
                    const Vec3f a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1), d = corner(i, j + 1);
                    shape.triangles.push_back({a, b, c});
                    shape.triangles.push_back({a, c, d});
                }
    return shape;
}

Shape make_wedge(const Vec3f &centre, float size, int n) {
    Shape shape{"wedge", true, centre, size, {}};
    const Eigen::Matrix3d turned = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    // Around the profile (edge, back, back); along the blade, closed at both ends by its middle line.
    const Vec3 profile[3] = {{-0.5, 0, 0}, {0.5, -0.0005, 0}, {0.5, 0.0005, 0}};
    add_grid(shape, n + 2, 3 * n, [&](int i, int j) -> Vec3 {
        const int k = j / n, along = std::clamp(i - 1, 0, n);
        const double t = double(j % n) / n;
        const Vec3 end(1.0 / 6, 0, 0.5 - double(along) / n);
        if (i == 0 || i == n + 2) return turned * end;
        return turned * Vec3(profile[k] * (1 - t) + profile[(k + 1) % 3] * t + Vec3(0, 0, end.z()));
    });
    return shape;
}

Shape make_ring(const Vec3f &centre, float size, int n) {
    Shape shape{"ring", false, centre, size, {}};
    add_grid(shape, n, n, [&](int i, int j) -> Vec3 {
        const double u = turn * (i % n) / n, v = -turn * j / n;
        const double thin = 0.12 * (1 + 0.3 * std::sin(7 * u) * std::cos(5 * v));
        return {(0.35 + thin * std::cos(v)) * std::cos(u), thin * std::sin(v),
                (0.35 + thin * std::cos(v)) * std::sin(u)};
    });
    return shape;
}

std::vector<accel::Triangle> make_soup(std::size_t count, std::uint32_t seed) {
    Random random(seed);
    std::vector<accel::Triangle> triangles(count);
    for (auto &triangle : triangles) {
        const Vec3f centre(uniform(random), uniform(random), uniform(random));
        for (Vec3f &v : triangle.v) v = centre + sphere_direction(random) * 0.1f;
    }
    return triangles;
}

} // namespace nacre
