#include "accel/modes.h"
#include "accel/shapes.h"
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <map>

namespace nacre {
namespace {

Vec3f normal_of(const accel::Triangle &t) { return (t.v[1] - t.v[0]).cross(t.v[2] - t.v[0]).normalized(); }

/// Rays from inside of a closed surface at its edges and vertices. t_max is a little beyond the target, so that a ray
/// which slips through misses even where it would meet something behind.
class Aimer {
  public:
    explicit Aimer(const Shape &shape) : shape(shape) {
        for (std::uint32_t i = 0; i < shape.triangles.size(); i++) {
            normals.push_back(normal_of(shape.triangles[i]));
            for (const Vec3f &v : shape.triangles[i].v) {
                around[key(v)].push_back(i);
                extent = std::max(extent, v.cwiseAbs().maxCoeff());
            }
        }
    }

    ProbeRay next(Random &random) const {
        for (;;) {
            const accel::Triangle &t = pick(random);
            const auto k = random() % 3;
            const Vec3f &a = t.v[k], &b = t.v[(k + 1) % 3];
            const auto kind = random() % 4;
            const Vec3f target = a + (b - a) * (kind == 0 ? 0 : kind == 1 ? 1e-6f : uniform(random));
            const Vec3f origin = inside(t, target, random), way = target - origin;
            const float distance = way.norm();
            if (!seen_from_inside(a, origin) || !seen_from_inside(b, origin)) continue;
            ProbeRay ray{origin, distance * 1.01f + 0.02f * shape.size, way / distance, 0};
            if (random() % 4 == 0) nudge(ray, random);
            return ray;
        }
    }

  private:
    using Key = std::array<std::uint32_t, 3>;
    static Key key(const Vec3f &v) {
        return {std::bit_cast<std::uint32_t>(v.x()), std::bit_cast<std::uint32_t>(v.y()),
                std::bit_cast<std::uint32_t>(v.z())};
    }

    const accel::Triangle &pick(Random &random) const { return shape.triangles[random() % shape.triangles.size()]; }

    /// Convex: anywhere inside, half of the time very near to the target. Else behind the triangle itself.
    Vec3f inside(const accel::Triangle &t, const Vec3f &target, Random &random) const {
        const Vec3f middle = (t.v[0] + t.v[1] + t.v[2]) / 3;
        if (!shape.convex) return middle - normal_of(t) * (shape.size * 0.02f * std::exp(-8 * uniform(random)));
        const Vec3f other = (pick(random).v[0] + pick(random).v[1]) / 2;
        const Vec3f deep = shape.centre + (other - shape.centre) * 0.9f * uniform(random);
        const float way = random() % 2 ? 1 - uniform(random) : std::exp(-9 * uniform(random));
        return target + (deep - target) * way;
    }

    /// All triangles at vertex v turn their inner sides to the origin, by more than their corners are rounded: there is
    /// no silhouette that a ray could rightly pass.
    bool seen_from_inside(const Vec3f &v, const Vec3f &origin) const {
        const std::vector<std::uint32_t> &neighbours = around.at(key(v));
        return std::all_of(neighbours.begin(), neighbours.end(),
                           [&](std::uint32_t i) { return normals[i].dot(v - origin) > 2e-6f * extent; });
    }

    /// Some last bits; now and then a component exactly 0 (of either sign) or almost, which turns the ray off its
    /// target: it must still hit something.
    static void nudge(ProbeRay &ray, Random &random) {
        float &c = ray.direction[int(random() % 3)];
        const auto kind = random() % 8;
        if (kind < 2 && std::abs(c) < 1e-3f) {
            c = std::copysign(kind == 0 ? 0.0f : 1e-30f, random() % 2 ? 1.0f : -1.0f);
            ray.t_max = std::numeric_limits<float>::infinity();
            return;
        }
        for (auto n = random() % 3; n > 0; n--) c = std::nextafter(c, random() % 2 ? 2.0f : -2.0f);
    }

    const Shape &shape;
    std::vector<Vec3f> normals;
    std::map<Key, std::vector<std::uint32_t>> around; // triangles by corner
    float extent = 0;
};

/// Rays from outside at a convex shape's border, where both neighbours face the ray well; or at its inside from far
/// away.
std::vector<ProbeRay> rays_from_outside(const Shape &shape, std::size_t count, std::uint32_t seed) {
    Random random(seed);
    std::vector<ProbeRay> rays;
    while (rays.size() < count) {
        const accel::Triangle &t = shape.triangles[random() % shape.triangles.size()];
        const int k = int(random() % 3);
        // A point of an edge, drawn a little into the shape: a ray to there must come through the surface.
        const Vec3f edge = t.v[k] + (t.v[(k + 1) % 3] - t.v[k]) * uniform(random);
        const Vec3f target = edge + (shape.centre - edge) * 0.02f;
        const float far = std::exp(7 * uniform(random)); // 1 to 1,000 sizes away
        const Vec3f origin = shape.centre + sphere_direction(random) * (shape.size * far);
        const Vec3f way = target - origin;
        // From the side on which the surface at the edge is seen, the target is behind it.
        rays.push_back({origin, way.norm(), way.normalized(), 0});
    }
    return rays;
}

struct Place {
    Vec3f centre;
    float size;
};
const Place places[] = {{{0, 0, 0}, 1}, {{0.3f, -40, 7}, 0.5f}, {{-300, 20, 1000}, 1000}, {{1e-3f, 2e-3f, 0}, 1e-4f}};

std::vector<Shape> shapes_at(const Place &p) {
    return {make_ball(p.centre, p.size, 64), make_cube(p.centre, p.size, 24), make_wedge(p.centre, p.size, 16),
            make_ring(p.centre, p.size, 96)};
}

std::size_t misses(RayProbe &probe, std::uint32_t root, const std::vector<ProbeRay> &rays) {
    std::size_t missed = 0;
    for (const ProbeHit &hit : probe.closest(root, rays)) missed += !hit.hit();
    for (const std::uint32_t hit : probe.any(root, rays)) missed += hit == 0;
    return missed;
}

void expect_watertight(const Mode &mode, std::size_t rays_per_shape) {
    constexpr std::size_t batch = 1 << 20;
    for (const Place &place : places) {
        const std::vector<Shape> shapes = shapes_at(place);
        accel::Bvh bvh;
        bvh.width = mode.width;
        std::vector<std::uint32_t> roots;
        for (const Shape &shape : shapes) roots.push_back(accel::append_tree(bvh, shape.triangles, 0));
        RayProbe probe(mode.open(), bvh);
        for (std::size_t i = 0; i < shapes.size(); i++) {
            const Shape &shape = shapes[i];
            const Aimer aimer(shape);
            Random random(1);
            std::size_t missed = 0;
            for (std::size_t done = 0; done < rays_per_shape; done += batch) {
                std::vector<ProbeRay> rays(std::min(batch, rays_per_shape - done));
                for (ProbeRay &ray : rays) ray = aimer.next(random);
                missed += misses(probe, roots[i], rays);
            }
            EXPECT_EQ(missed, 0u) << mode << ", " << shape.name << " of size " << place.size << " from inside";
            if (!shape.convex || shape.name == "wedge") continue;
            missed = misses(probe, roots[i], rays_from_outside(shape, rays_per_shape / 8, 3));
            EXPECT_EQ(missed, 0u) << mode << ", " << shape.name << " of size " << place.size << " from outside";
        }
    }
}

/// Every edge runs once each way, and the volume is positive: what the rays below rely on.
TEST(Shapes, AreClosedAndTurnedOutwards) {
    using Corner = std::array<float, 3>;
    const auto corner = [](const Vec3f &v) { return Corner{v.x(), v.y(), v.z()}; };
    for (const Place &place : places)
        for (const Shape &shape : shapes_at(place)) {
            std::map<std::pair<Corner, Corner>, int> edges;
            double volume = 0;
            for (const accel::Triangle &t : shape.triangles) {
                for (int k = 0; k < 3; k++) {
                    edges[{corner(t.v[k]), corner(t.v[(k + 1) % 3])}]++;
                    edges[{corner(t.v[(k + 1) % 3]), corner(t.v[k])}]--;
                }
                const Vec3 a = (t.v[0] - shape.centre).cast<double>();
                volume += a.dot((t.v[1] - t.v[0]).cast<double>().cross((t.v[2] - t.v[0]).cast<double>()));
            }
            EXPECT_TRUE(std::all_of(edges.begin(), edges.end(), [](const auto &edge) { return edge.second == 0; }))
                << shape.name << " of size " << shape.size;
            EXPECT_GT(volume, 0) << shape.name << " of size " << shape.size;
        }
}

class Watertight : public testing::TestWithParam<Mode> {};
INSTANTIATE_TEST_SUITE_P(Modes, Watertight, testing::ValuesIn(all_modes),
                         [](const auto &info) { return mode_name(info.param); });

TEST_P(Watertight, AtEdgesAndVertices) { expect_watertight(GetParam(), 15000); }

TEST(LongWatertight, AtEdgesAndVertices) {
    for (const Mode &mode : {Mode{16, true}, Mode{4, false}}) expect_watertight(mode, 100'000'000 / (2 * 4 * 4));
}

} // namespace
} // namespace nacre
