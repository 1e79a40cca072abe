// White bodies of awkward shape in a white sky: what falls in comes out, whatever the triangles.
#include "image/rendered.h"
#include "io/object.h"
#include "scene/bounds.h"
#include "scene/normalise.h"
#include "stress/bodies.h"
#include "stress/tally.h"
#include <algorithm>
#include <gtest/gtest.h>

namespace nacre::stress {
namespace {

using namespace shared;

struct Shape {
    std::string name;
    std::vector<scene::Mesh> objects; // each an object of its own
    double missed = 2e-4;             // share of walks that may leave through the surface unseen, with their light
};

void append(scene::Mesh &mesh, const scene::Mesh &more) {
    const auto first = std::uint32_t(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
    for (const auto &t : more.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    mesh.normals.clear();
    mesh.uvs.clear();
}

scene::Mesh joined(const std::vector<scene::Mesh> &parts) {
    scene::Mesh mesh;
    for (const scene::Mesh &part : parts) append(mesh, part);
    return mesh;
}

scene::Mesh box(const Vec3 &lower, const Vec3 &upper) { return scene::make_box(lower, upper); }

/// A box with two sides cut into `count` triangles each, from their common edge to one corner: slivers.
scene::Mesh fan_box(int count) {
    scene::Mesh mesh = joined({box(-Vec3::Ones(), Vec3::Ones())});
    for (const int axis : {0, 2}) // the two sides that meet in the edge from (1, -1, 1) to (1, 1, 1) are made anew
        std::erase_if(mesh.triangles, [&](const auto &t) {
            return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return mesh.positions[v][axis] == 1; });
        });
    const auto add = [&](const Vec3 &a, const Vec3 &b, const Vec3 &c) {
        const auto first = std::uint32_t(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), {a, b, c});
        mesh.triangles.push_back({first, first + 1, first + 2});
    };
    add({-1, -1, 1}, {1, -1, 1}, {1, -1, 1}); // no area: dropped when it is read
    add({1, -1, -1}, {1, 1, -1}, {1, -1, 1});
    for (int i = 0; i < count; ++i) {
        const double y0 = -1 + 2.0 * i / count, y1 = i + 1 == count ? 1 : -1 + 2.0 * (i + 1) / count;
        add({-1, -1, 1}, {1, y0, 1}, {1, y1, 1});
        add({1, 1, -1}, {1, y1, 1}, {1, y0, 1});
    }
    add({-1, -1, 1}, {1, 1, 1}, {-1, 1, 1});
    return mesh;
}

scene::Mesh stretched(scene::Mesh mesh, const Vec3 &scale) {
    scene::apply(mesh, Transform(Eigen::Scaling(scale)));
    return mesh;
}

std::vector<Shape> shapes() {
    const scene::Mesh left = box({-1, -.5, -.5}, {0, .5, .5}), right = box({0, -.5, -.5}, {1, .5, .5}),
                      inner = box({-.5, -.25, -.25}, {.5, .25, .5});
    std::vector<Shape> all{
        // The distance of a hit is rounded by some 1e-7 of a triangle's length over its width.
        {"slivers 1e2", {fan_box(100)}, 1e-3},
        {"slivers 1e4", {fan_box(10000)}, .1},
        {"needle 1e-2", {stretched(scene::make_sphere({0, 0, 0}, 1, 64), {1, 1e-2, 1e-2})}},
        {"needle 1e-4", {stretched(scene::make_sphere({0, 0, 0}, 1, 64), {1, 1e-4, 1e-4})}},
        {"disc 1e-4", {stretched(scene::make_sphere({0, 0, 0}, 1, 64), {1, 1, 1e-4})}},
        // What is left and what is entered in one place comes in either order.
        {"touching shells", {joined({left, right})}, .2},
        {"touching bodies", {left, right}, .2},
        {"shell twice", {joined({left, left})}, .2},
        {"body twice", {left, left}, .2},
        {"coplanar shell inside", {joined({box({-1, -.5, -.5}, {1, .5, .5}), inner})}, .2},
        {"coplanar body inside", {box({-1, -.5, -.5}, {1, .5, .5}), inner}, .2},
        {"ball", {scene::make_sphere({0, 0, 0}, 1, 256)}},
    };
    return all;
}

scene::Scene scene_of(const Shape &shape, double free_path, double g, double bleed) {
    scene::Scene scene;
    double size = 0;
    for (const scene::Mesh &mesh : shape.objects) {
        scene.objects.push_back(
            io::make_object(shape.name, mesh, Transform::Identity(), false, shape.name, scene.warnings));
        const scene::Bounds bounds = scene::bounds(scene.objects.back().mesh);
        size = std::max(size, bounds.sizes().minCoeff());
    }
    scene.materials = {material_of({.g = g, .bleed = bleed, .free_path = free_path * size})};
    scene.lights.emplace_back();
    scene.lights.back().visible = true;
    scene.camera.kind = CAMERA_ORTHOGRAPHIC;
    scene.camera.position = {0, 0, 4};
    scene.camera.height = 1.2 * size;
    scene.image = {24, 24};
    scene.render.spp = 64; // some 3e4 walks: with a tenth of it a single lost one would be over the bound
    scene.render.max_depth = 0;
    scene.render.guiding = GUIDING_NONE;
    return scene;
}

void check(const std::vector<Shape> &all) {
    Tally tally("Shapes");
    for (std::size_t i = 0; i < all.size(); ++i)
        for (const double free_path : {1e-2, 10.})
            for (const auto &[g, bleed] : {std::pair{.5, .5}, {.999, .5}}) {
                const scene::Scene scene = scene_of(all[i], free_path, g, bleed);
                // Less is outside the domain: walks are lost in the rounding of their positions.
                if (scene.materials[0][PARAMETER_subsurface_radius].value.x() < 3e-6 * scene::frame_of(scene).size)
                    continue;
                const Rendered found = rendered(scene, with_variance());
                const Seen whole = seen(found.picture, 0, 0, 24, 24);
                std::size_t covered = 0;
                for (int y = 0; y < 24; ++y)
                    for (int x = 0; x < 24; ++x) covered += found.at(x, y, 3) > 0;
                const auto missed = found.statistics[COUNTER_missed], walks = found.statistics[COUNTER_walks],
                           escaped = found.statistics[COUNTER_escaped];
                const bool held = whole.finite && whole.largest <= 1 + 1e-4 && whole.is(Vec3::Ones(), 1e-4) &&
                                  escaped == 0 && double(missed) <= all[i].missed * double(walks) && covered > 24 &&
                                  found.statistics[COUNTER_non_finite] == 0;
                tally.add({{"shape", double(i)}, {"free path", free_path}, {"g", g}}, held,
                          fmt::format("{}: {}, {} missed and {} escaped of {} walks", all[i].name, whole.text(), missed,
                                      escaped, walks));
            }
    tally.expect_all();
}

TEST(Shapes, AreWhite) { check(shapes()); }
TEST(LongShapes, FourMillionTriangles) {
    check({{"ball of 4 million", {scene::make_sphere({0, 0, 0}, 1, 2048)}},
           {"needle of 4 million", {stretched(scene::make_sphere({0, 0, 0}, 1, 2048), {1, 1e-3, 1e-3})}}});
}

} // namespace
} // namespace nacre::stress
