// Few lights are drawn by what they bring to a point, many by their power, points on them evenly, and what is drawn is
// divided by its chance.
#include "device/chi_square.h"
#include "device/light_probe.h"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace nacre::test {
namespace {

using namespace shared;

constexpr std::uint32_t samples = 1 << 20;

double luminance(const Vec3 &c) { return c.dot(Vec3(.2126, .7152, .0722)); }

TEST(LightChoice, ManyPointsByTheirIntensity) {
    scene::Scene scene = scene_with_box();
    const Vec3 from(0, 3, 0);
    std::vector<double> shares;
    for (int i = 0; i < 37; ++i) {
        scene::Light light;
        light.kind = LIGHT_POINT;
        light.position = from + Vec3(std::cos(i * .17), std::sin(i * .17), .05 * i);
        // The fifth is dark, the last as bright as all the others.
        light.radiance = i == 5 ? Vec3(0, 0, 0) : i == 36 ? Vec3(50, 60, 1) : Vec3(1 + i % 3, .1 * i, 2);
        scene.lights.push_back(light);
        shares.push_back(luminance(light.radiance));
    }
    scene::Light sky; // constant: never drawn
    scene.lights.insert(scene.lights.begin() + 3, sky);
    double total = 0;
    for (const double share : shares) total += share;

    std::vector<std::uint64_t> observed(shares.size());
    for (const LightDraw &draw : draw_lights(scene, from, {0, 1, 0}, samples, 1)) {
        ASSERT_GT(draw.distance, 0);
        ASSERT_EQ(draw.density, 0);
        std::size_t nearest = 0;
        double least = 10;
        for (std::size_t i = 0; i < shares.size(); ++i) {
            const Vec3 to = scene.lights[i < 3 ? i : i + 1].position - from;
            if ((to - draw.direction * draw.distance).norm() < least) {
                least = (to - draw.direction * draw.distance).norm();
                nearest = i;
            }
        }
        ++observed[nearest];
        const scene::Light &light = scene.lights[nearest < 3 ? nearest : nearest + 1];
        const Vec3 exact = light.radiance / (light.position - from).squaredNorm() * total / shares[nearest];
        ASSERT_LE((draw.radiance - exact).norm(), 2e-5 * exact.norm()) << nearest;
    }
    EXPECT_EQ(observed[5], 0u);
    expect_distribution(observed, shares, "37 points");
}

// What they bring: irradiance, known exactly for points and directions, about for the rect, whose centre is far. Lights
// below the horizon and backs of rects bring nothing.
TEST(LightChoice, FewByWhatTheyBring) {
    scene::Scene scene = scene_with_box();
    const Vec3 from(0, 3, 0), normal = Vec3(1, 2, 0).normalized();
    const auto add = [&](LightKind kind, const Vec3 &at, const Vec3 &radiance) -> scene::Light & {
        scene::Light &light = scene.lights.emplace_back();
        light.kind = kind;
        light.radiance = radiance;
        (kind == LIGHT_DIRECTIONAL ? light.direction : light.position) = at;
        return light;
    };
    add(LIGHT_POINT, from + Vec3(1, 2, 0), {30, 20, 10});
    add(LIGHT_POINT, from + Vec3(-1, 2, .5), {30, 20, 10});
    add(LIGHT_POINT, from + Vec3(-2, .9, 0), {1000, 1000, 1000}); // below the horizon
    add(LIGHT_DIRECTIONAL, Vec3(0, -1, 0), {1, 2, 3});
    for (const double side : {1., -1.}) { // one shows its back
        scene::Light &rect = add(LIGHT_RECT, from + Vec3(0, 4, 0), {20, 20, 20});
        rect.u = {.5, 0, 0};
        rect.v = {0, 0, side * .5};
        if (side > 0) rect.position.x() = .25;
    }
    std::vector<std::uint64_t> observed(scene.lights.size());
    std::vector<double> chances(scene.lights.size()), brought(scene.lights.size());
    for (const LightDraw &draw : draw_lights(scene, from, normal, samples, 4)) {
        ASSERT_GT(draw.distance, 0);
        std::size_t i = 3;
        double irradiance = 0;
        if (draw.density > 0) {
            i = 4;
            irradiance = luminance(draw.radiance) * draw.density * .25 / 16; // all of the rect: its solid angle, about
        } else {
            for (const std::size_t k : {0, 1, 2})
                if ((from + draw.direction * draw.distance - scene.lights[k].position).norm() < 1e-4) i = k;
            irradiance = i == 3 ? luminance(scene.lights[3].radiance)
                                : luminance(scene.lights[i].radiance) / (draw.distance * draw.distance);
            chances[i] = irradiance / luminance(draw.radiance);
        }
        ++observed[i];
        brought[i] = irradiance * std::max(0., draw.direction.dot(normal));
    }
    EXPECT_EQ(observed[2], 0u);
    EXPECT_EQ(observed[5], 0u);
    double total = 0, rest = 1;
    for (std::size_t i = 0; i < brought.size(); ++i) {
        total += brought[i];
        rest -= chances[i];
    }
    chances[4] = rest;
    expect_distribution(observed, chances, "few lights");
    for (const std::size_t i : {0, 1, 3, 4}) {
        EXPECT_GT(chances[i], .6 * brought[i] / total) << i;
        EXPECT_LT(chances[i], 1.5 * brought[i] / total) << i;
    }
}

/// Where a draw lies in the parallelogram of `corner`, `u`, `v`.
Vec2 place(const LightDraw &draw, const Vec3 &from, const Vec3 &corner, const Vec3 &u, const Vec3 &v) {
    const Vec3 at = from + draw.direction * draw.distance - corner, n = u.cross(v);
    return {at.cross(v).dot(n) / n.squaredNorm(), u.cross(at).dot(n) / n.squaredNorm()};
}

/// Checks that those of `draws` that lie in the parallelogram (if `alone`: all) are even over it, and that 1 / density
/// adds up to its solid angle.
void check_flat(const std::vector<LightDraw> &draws, const Vec3 &from, const Vec3 &corner, const Vec3 &u, const Vec3 &v,
                const Vec3 &radiance, const char *what, bool alone = true) {
    std::vector<double> a, b;
    double sum = 0, squares = 0;
    for (const LightDraw &draw : draws) {
        ASSERT_GT(draw.density, 0);
        const Vec3 off = from + draw.direction * draw.distance - corner;
        if (!alone && std::abs(off.dot(u.cross(v).normalized())) > 1e-4) continue;
        const Vec2 at = place(draw, from, corner, u, v);
        a.push_back(at.x());
        b.push_back(at.y());
        ASSERT_LE((draw.radiance * draw.density - radiance).norm(), 1e-5 * radiance.norm());
        sum += 1 / draw.density;
        squares += 1 / (draw.density * draw.density);
    }
    expect_uniform(a, b, 32, what);
    double solid_angle = 0; // midpoints of 400 x 400 parts
    for (int i = 0; i < 160000; ++i) {
        const Vec3 to = corner + (i / 400 + .5) / 400 * u + (i % 400 + .5) / 400 * v - from;
        solid_angle += std::abs(to.dot(u.cross(v))) / std::pow(to.norm(), 3) / 160000;
    }
    const double n = double(draws.size()), mean = sum / n;
    EXPECT_NEAR(mean, solid_angle, 4 * std::sqrt((squares / n - mean * mean) / n)) << what;
}

TEST(LightChoice, RectsAreEvenlyCovered) {
    scene::Scene scene = scene_with_box();
    scene::Light rect;
    rect.kind = LIGHT_RECT;
    rect.position = {.3, 3, -.2};
    rect.u = {2, 0, .5}; // skewed: a parallelogram
    rect.v = {.7, .2, 1};
    if (rect.u.cross(rect.v).y() > 0) std::swap(rect.u, rect.v); // emits downwards
    rect.radiance = {3, 2, 1};
    scene.lights = {rect};
    const Vec3 from(0, 1.5, 0);
    check_flat(draw_lights(scene, from, {0, 1, 0}, samples, 2), from, rect.position - .5 * (rect.u + rect.v), rect.u,
               rect.v, rect.radiance, "rect");
    for (const LightDraw &draw : draw_lights(scene, {0, 5, 0}, {0, -1, 0}, 64, 2))
        EXPECT_EQ(draw.distance, 0) << "from behind";
}

// The number that draws one of few lights draws the point as well. One is behind the other.
TEST(LightChoice, EachOfTwoRectsIsEvenlyCovered) {
    scene::Scene scene = scene_with_box();
    const Vec3 from(0, 1.5, 0);
    for (const double height : {1., 1.5}) {
        scene::Light &rect = scene.lights.emplace_back();
        rect.kind = LIGHT_RECT;
        rect.position = from + Vec3(.2, height, 0);
        rect.u = {1, 0, 0};
        rect.v = {0, 0, 2};
        rect.radiance = Vec3(3, 2, 1) * (height * height);
    }
    const std::vector<LightDraw> draws = draw_lights(scene, from, {0, 1, 0}, 5 * samples / 2, 5);
    for (const scene::Light &rect : scene.lights)
        check_flat(draws, from, rect.position - .5 * (rect.u + rect.v), rect.u, rect.v, rect.radiance, "one of two",
                   false);
}

// A square of triangles of many sizes, too many to be weighed one by one: even only if they are drawn by their area.
TEST(LightChoice, EmittingTrianglesAreEvenlyCovered) {
    scene::Scene scene = scene_with_box();
    scene::Material glow;
    glow[PARAMETER_emission_luminance].value = Vec3::Constant(2);
    glow[PARAMETER_emission_color].value = {1, .5, .25};
    scene.materials.push_back(glow);
    scene::Mesh square;
    for (std::uint32_t i = 0; i < 25; ++i)
        square.positions.push_back({-1 + (i % 5) * (i % 5) / 8., 3, -1 + i / 5 / 2.});
    for (std::uint32_t i = 0; i < 20; ++i) {
        if (i % 5 == 4) continue;
        square.triangles.push_back({i, i + 1, i + 6}); // counter-clockwise from below
        square.triangles.push_back({i, i + 6, i + 5});
    }
    scene.objects.push_back({"square", square, 1, 0});
    const Vec3 from(.2, 1.5, .3);
    check_flat(draw_lights(scene, from, {0, 1, 0}, samples, 3), from, {-1, 3, -1}, {2, 0, 0}, {0, 0, 2}, {2, 1, .5},
               "triangles");
}

} // namespace
} // namespace nacre::test
