#include "accel/clearance.h"
#include "accel/clearance_probe.h"
#include "accel/shapes.h"
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace nacre {
namespace {

/// Distance to a triangle, in double: Ericson, "Real-Time Collision Detection", 5.1.5 (by regions of its plane, where
/// the field's builder measures edges).
double distance_to(const accel::Triangle &triangle, const Vec3 &p) {
    const Vec3 a = triangle.v[0].cast<double>(), b = triangle.v[1].cast<double>(), c = triangle.v[2].cast<double>();
    const Vec3 ab = b - a, ac = c - a;
    const double d1 = ab.dot(p - a), d2 = ac.dot(p - a), d3 = ab.dot(p - b), d4 = ac.dot(p - b);
    const double d5 = ab.dot(p - c), d6 = ac.dot(p - c);
    if (d1 <= 0 && d2 <= 0) return (p - a).norm();
    if (d3 >= 0 && d4 <= d3) return (p - b).norm();
    if (d6 >= 0 && d5 <= d6) return (p - c).norm();
    const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return (p - a - ab * (d1 / (d1 - d3))).norm();
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return (p - a - ac * (d2 / (d2 - d6))).norm();
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
        return (p - b - (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)))).norm();
    return (p - a - ab * (vb / (va + vb + vc)) - ac * (vc / (va + vb + vc))).norm();
}

double distance_to(std::span<const accel::Triangle> triangles, const Vec3f &p) {
    double least = std::numeric_limits<double>::infinity();
    for (const accel::Triangle &triangle : triangles) least = std::min(least, distance_to(triangle, p.cast<double>()));
    return least;
}

/// In the box about the shape, close to its surface, and far outside.
std::vector<ClearancePoint> points_about(const Shape &shape, std::size_t count, std::uint32_t seed) {
    Random random(seed);
    std::vector<ClearancePoint> points;
    for (std::size_t i = 0; i < count; i++) {
        const float pick = uniform(random);
        Vec3f p = shape.centre + shape.size * (Vec3f(uniform(random), uniform(random), uniform(random)) * 1.2f -
                                               Vec3f::Constant(0.6f));
        if (pick < 0.3f) {
            const auto &v = shape.triangles[random() % shape.triangles.size()].v;
            const float u = uniform(random), w = uniform(random) * (1 - u);
            p = v[0] + u * (v[1] - v[0]) + w * (v[2] - v[0]);
            p += sphere_direction(random) * shape.size * std::pow(10.0f, -1 - 6 * uniform(random));
        } else if (pick < 0.4f) {
            p = shape.centre + sphere_direction(random) * shape.size * std::pow(10.0f, 3 * uniform(random));
        }
        points.push_back({p, 0});
    }
    return points;
}

float cell_of(const accel::ClearanceField &field) { return field.info.corner.w; }
float diagonal_of(const accel::ClearanceField &field) { return std::sqrt(3.0f) * cell_of(field); }

std::vector<Shape> shapes() {
    std::vector<Shape> list{make_ball({0, 0, 0}, 1, 12),
                            make_cube({0.3f, -0.2f, 0.1f}, 0.8f, 9),
                            make_wedge({0, 0.1f, 0}, 1, 8),
                            make_ring({0, 0, 0}, 1, 16),
                            {"soup", false, {0, 0, 0}, 2, make_soup(150, 5)}};
    list.push_back(
        {"sliver", false, {0, 0, 0}, 1, {{{Vec3f(-.5f, -.5f, -.5f), Vec3f(.5f, .5f, .5f), Vec3f(.5f, .5f, .50001f)}}}});
    list.push_back(
        {"flat", false, {0, 0, 0.5f}, 1, {{{Vec3f(-.5f, -.5f, .5f), Vec3f(.5f, -.5f, .5f), Vec3f(.5f, .5f, .5f)}}}});
    return list;
}

bool in_grid(const accel::ClearanceField &field, const Vec3f &p) {
    const shared::Clearance &info = field.info;
    const Vec3f cell = (p - Vec3f(info.corner.x, info.corner.y, info.corner.z)) / info.corner.w;
    return (cell.array() > 0).all() && cell.x() < 4 * float(info.bricks_x) && cell.y() < 4 * float(info.bricks_y) &&
           cell.z() < 4 * float(info.bricks_z);
}

/// Never above the true distance, and worth having: where that is far, less than 2 diagonals of a cell are lost. Half
/// of one lies between the point and the centre of its cell and counts twice, another half between the surface and the
/// centre of a cell that it may pass through, another between that centre and its box. On average half of that is lost,
/// and a little more about thin things.
TEST(Clearance, BoundsTheDistance) {
    const device::Device device = device::open_device();
    for (const Shape &shape : shapes()) {
        for (const float cell : {0.1f, 0.02f}) {
            SCOPED_TRACE(shape.name + " " + std::to_string(cell));
            accel::ClearanceField field = accel::build_clearance(shape.triangles, cell * shape.size, 8 << 20);
            ASSERT_GT(field.info.bricks_x, 0u);
            const auto points = points_about(shape, 8192, 17);
            const auto bounds = look_up(device, {&field, 1}, points, 4);
            std::size_t above = 0, far = 0, poor = 0;
            double lost = 0;
            for (std::size_t i = 0; i < points.size(); i++) {
                const double true_distance = distance_to(shape.triangles, points[i].position);
                above += !(bounds[i] >= 0 && bounds[i] <= true_distance);
                if (true_distance < 2 * diagonal_of(field) || !in_grid(field, points[i].position)) continue;
                far++;
                poor += bounds[i] + 2 * diagonal_of(field) < 0.98 * true_distance; // codes are 1/128 apart
                lost += 0.98 * true_distance - bounds[i];
            }
            EXPECT_EQ(above, 0u);
            EXPECT_EQ(poor, 0u) << far << " points";
            EXPECT_LE(lost, 1.2 * double(far) * diagonal_of(field)) << far << " points";
        }
    }
}

/// Where it counts, close to the surface: of what can be known one cell away, less than a cell's half diagonal is lost.
TEST(Clearance, IsExactNearTheSurface) {
    const Shape shape = make_ring({0, 0, 0}, 1, 16);
    accel::ClearanceField field = accel::build_clearance(shape.triangles, 0.03f, 8 << 20);
    const shared::Clearance &info = field.info;
    std::vector<ClearancePoint> centres;
    for (std::uint32_t z = 0; z < 4 * info.bricks_z; z++)
        for (std::uint32_t y = 0; y < 4 * info.bricks_y; y++)
            for (std::uint32_t x = 0; x < 4 * info.bricks_x; x++)
                centres.push_back({Vec3f(info.corner.x, info.corner.y, info.corner.z) +
                                   cell_of(field) * Vec3f(float(x) + .5f, float(y) + .5f, float(z) + .5f)});
    const auto bounds = look_up(device::open_device(), {&field, 1}, centres, 8);
    std::size_t near = 0;
    for (std::size_t i = 0; i < centres.size(); i++) {
        const double true_distance = distance_to(shape.triangles, centres[i].position);
        ASSERT_LE(bounds[i], true_distance);
        if (true_distance > 1.99 * cell_of(field)) continue;
        near++;
        // The step between codes there, and some for rounding.
        const double step = info.unit * (2 * std::sqrt(true_distance / info.unit) + 1);
        ASSERT_GE(bounds[i], true_distance - step - 1e-5) << i;
    }
    EXPECT_GT(near, 1000u);
}

/// Two objects in one buffer, every lane in either or in one without a field; one answer, whatever the lanes.
TEST(Clearance, LanesAgree) {
    const device::Device device = device::open_device();
    const Shape ring = make_ring({0, 0, 0}, 1, 16), cube = make_cube({0.2f, 0, 0}, 0.5f, 9);
    std::vector<accel::ClearanceField> fields{accel::build_clearance(ring.triangles, 0.02f, 1 << 20),
                                              {},
                                              accel::build_clearance(cube.triangles, 0.05f, 1 << 20)};
    auto points = points_about(ring, 100003, 23);
    for (std::size_t i = 0; i < points.size(); i++) points[i].field = std::uint32_t(i * 7 / 3 % 3);
    const auto one = look_up(device, fields, points, 1);
    for (std::size_t i = 0; i < points.size(); i++) ASSERT_TRUE(points[i].field != 1 || one[i] == 0);
    std::size_t above = 0;
    for (std::size_t i = 0; i < 3000; i++)
        if (points[i].field != 1)
            above += one[i] > distance_to(points[i].field ? cube.triangles : ring.triangles, points[i].position);
    EXPECT_EQ(above, 0u);
    for (const int lanes : {4, 8, 16}) EXPECT_EQ(look_up(device, fields, points, lanes), one) << lanes;
}

TEST(Clearance, PointsThatAreNone) {
    const Shape ball = make_ball({0, 0, 0}, 1, 12);
    const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    std::vector<ClearancePoint> points;
    for (const float bad : {inf, -inf, nan, 1e30f, -1e30f, std::numeric_limits<float>::max(), 1e10f})
        for (int axis = 0; axis < 3; axis++) {
            points.push_back({});
            points.back().position[axis] = bad;
            points.push_back({Vec3f::Constant(bad)});
        }
    for (const bool some : {true, false}) {
        accel::ClearanceField field;
        if (some) field = accel::build_clearance(ball.triangles, 0.02f, 1 << 20);
        for (const int lanes : {1, 4, 8, 16})
            for (const float bound : look_up(device::open_device(), {&field, 1}, points, lanes)) ASSERT_EQ(bound, 0);
    }
}

TEST(Clearance, NoFieldWhereThereIsNothing) {
    const auto ball = make_ball({0, 0, 0}, 1, 12).triangles;
    const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    const Vec3f a(0, 0, 0), b(1, 1, 1);
    const std::vector<accel::Triangle> hopeless{
        {{a, b, 0.5f * b}}, {{a, a, a}}, {{a, b, Vec3f(nan, 0, 0)}}, {{a, b, Vec3f(0, inf, 0)}}};
    for (const auto &field :
         {accel::build_clearance({}, 0.1f, 1 << 20), accel::build_clearance(hopeless, 0.1f, 1 << 20),
          accel::build_clearance(ball, 0.1f, 0), accel::build_clearance(ball, 0.1f, 63),
          accel::build_clearance(ball, 0, 1 << 20), accel::build_clearance(ball, nan, 1 << 20),
          accel::build_clearance(ball, inf, 1 << 20), accel::build_clearance(ball, -1, 1 << 20)}) {
        EXPECT_EQ(field.info.bricks_x, 0u);
        EXPECT_TRUE(field.bricks.empty());
    }
    // What no ray can hit is no surface.
    auto more = ball;
    more.push_back({{Vec3f(-9, 0, 0), Vec3f(9, 0, 0), Vec3f(0, 0, 0)}});
    EXPECT_EQ(accel::build_clearance(more, 0.05f, 1 << 20).bricks, accel::build_clearance(ball, 0.05f, 1 << 20).bricks);
}

TEST(Clearance, KeepsToItsBudget) {
    for (const Shape &shape : shapes())
        for (const std::size_t budget : {64u, 100u, 1000u, 30000u, 262144u}) {
            const auto field = accel::build_clearance(shape.triangles, 1e-6f, budget);
            const shared::Clearance &info = field.info;
            EXPECT_EQ(field.bricks.size(),
                      std::size_t(CLEARANCE_BRICK_BYTES) * info.bricks_x * info.bricks_y * info.bricks_z);
            EXPECT_LE(field.bricks.size(), budget);
            EXPECT_GE(2.2 * double(field.bricks.size()), double(std::min<std::size_t>(budget, 16384)))
                << shape.name << " " << budget;
        }
    // Cells of the wanted size where they fit.
    const auto field = accel::build_clearance(make_cube({0, 0, 0}, 1, 9).triangles, 0.05f, 1 << 20);
    EXPECT_NEAR(cell_of(field), 0.05f, 1e-6f);
}

/// Sizes and places far from 1: the kernels' scenes are normalised, but a field need not be told.
TEST(Clearance, HugeAndTiny) {
    const device::Device device = device::open_device();
    for (const float size : {1e-12f, 1e-3f, 1e6f, 1e12f})
        for (const float offset : {0.0f, 100 * size}) {
            const Shape ball = make_ball({offset, 0, -offset}, size, 8);
            accel::ClearanceField field = accel::build_clearance(ball.triangles, 0.05f * size, 1 << 20);
            const auto points = points_about(ball, 4096, 3);
            const auto bounds = look_up(device, {&field, 1}, points, 4);
            std::size_t above = 0, useful = 0;
            for (std::size_t i = 0; i < points.size(); i++) {
                above += !(bounds[i] >= 0 && bounds[i] <= distance_to(ball.triangles, points[i].position));
                useful += bounds[i] > 0;
            }
            EXPECT_EQ(above, 0u) << size << " " << offset;
            EXPECT_GT(useful, points.size() / 3) << size << " " << offset;
        }
}

TEST(Clearance, CellsFollowTheMeanFreePath) {
    EXPECT_FLOAT_EQ(accel::clearance_cell({0.01f, 0.01f, 0.01f}, 2), 0.01f);
    EXPECT_FLOAT_EQ(accel::clearance_cell({0.04f, 0.01f, 0.0025f}, 2), 0.01f);
    EXPECT_FLOAT_EQ(accel::clearance_cell(Vec3f::Constant(1), 2), 2.0f / 64);
    EXPECT_FLOAT_EQ(accel::clearance_cell(Vec3f::Constant(1e-6f), 2), 2.0f / 256);
    EXPECT_TRUE(accel::clearance_pays({0.1f, 0.05f, 0.02f}, 1));
    EXPECT_FALSE(accel::clearance_pays({1, 0.5f, 0.25f}, 1));
}

} // namespace
} // namespace nacre
