#include "error_time/scenarios.h"
#include "base/error.h"
#include "io/load.h"
#include <optional>

namespace nacre::bench {
namespace {

using namespace shared;

constexpr int pixels = 64; // a side

scene::Light rect(const Vec3 &center, const Vec3 &u, const Vec3 &v, const Vec3 &radiance) {
    scene::Light light;
    light.kind = LIGHT_RECT;
    light.position = center;
    light.u = u;
    light.v = v;
    light.radiance = radiance;
    return light;
}

/// Of skin whose red light goes `radius` between scatters.
scene::Scene body(scene::Mesh mesh, double radius) {
    scene::Scene scene;
    scene::Material &material = scene.materials.emplace_back();
    material[PARAMETER_specular_weight].value = Vec3::Zero();
    material[PARAMETER_subsurface_weight].value = Vec3::Ones();
    material[PARAMETER_subsurface_color].value = {.8, .5, .4};
    material[PARAMETER_subsurface_radius].value = Vec3::Constant(radius);
    material[PARAMETER_subsurface_radius_scale].value = {1, .35, .2};
    scene.objects.push_back({.name = "body", .mesh = std::move(mesh)});
    scene.image = {pixels, pixels};
    return scene;
}

/// A block four mean free paths of red thick, seen from the front, with a lamp at its back.
scene::Scene slab() {
    scene::Scene scene = body(scene::make_box({-4, -4, -1}, {4, 4, 0}), .25);
    scene.camera.position = {0, 0, 6};
    scene.lights.push_back(rect({0, 0, -4}, {4, 0, 0}, {0, 4, 0}, {10, 10, 10}));
    return scene;
}

/// Two units across, with a lamp and some sky.
scene::Scene ball(double radius) {
    scene::Scene scene = body(scene::make_sphere({0, 0, 0}, 1, 256), radius);
    scene.lights.emplace_back().radiance = Vec3::Constant(.3);
    scene.lights.push_back(rect({3, 3, 3}, {-1, 2, -1}, {2, 0, -2}, {6, 6, 6}));
    return scene;
}

scene::Scene bear() {
    scene::Scene scene = io::load_scene(NACRE_SCENES "/bear/bear.json");
    scene.image = {pixels, pixels};
    return scene;
}

/// In even light from everywhere, alone.
scene::Scene bear_in_environment() {
    scene::Scene scene = bear();
    scene.objects.resize(1);
    scene.lights.assign(1, {});
    return scene;
}

/// Without its normal map, which renderers read differently. Its files are not in this repository.
std::optional<scene::Scene> head(double g) {
    try {
        scene::Scene scene = io::load_scene(NACRE_SCENES "/head/head.json",
                                            {{"materials.skin.subsurface_scatter_anisotropy", std::to_string(g)}});
        for (scene::Material &material : scene.materials) material[PARAMETER_geometry_normal].texture = -1;
        scene.image = {pixels, pixels * 5 / 4};
        return scene;
    } catch (const MissingFile &) {
        return {};
    }
}

} // namespace

std::vector<Scenario> scenarios() {
    std::vector<Scenario> all;
    all.push_back({"bear", "the gummy bear as in scenes/bear, lit from behind, on paper", bear()});
    all.push_back({"bear_environment", "the gummy bear alone, in even light from everywhere", bear_in_environment()});
    all.push_back({"slab", "a slab of four mean free paths (of red), lit from behind", slab()});
    all.push_back({"dense", "a ball, mean free path .2 % of its size", ball(.004)});
    all.push_back({"thin", "a ball, mean free path 30 % of its size", ball(.6)});
    if (auto scene = head(0)) all.push_back({"head_g0", "the memo's head, g = 0", std::move(*scene)});
    if (auto scene = head(.8)) all.push_back({"head_g0.8", "the memo's head, g = .8", std::move(*scene)});
    return all;
}

} // namespace nacre::bench
