#include "guiding/guide_scenes.h"
#include "base/error.h"
#include "io/load.h"
#include "render/body.h"
#include <fmt/format.h>
#include <numbers>

namespace nacre::bench {
namespace {

using namespace shared;

constexpr int pixels = 128; // a side

// Wide enough for light of slabs not to reach the edge.
constexpr double slab_width = 200;
// What the camera sees of a flat patch.
constexpr double patch = 10;

std::string name_of(const char *body, const Medium &m) {
    return fmt::format("{}/{}/g{:g}/b{:g}", body, m.name, m.anisotropy, m.bleed);
}

scene::Scene scene_of(const Medium &medium, scene::Mesh mesh, double height) {
    scene::Scene scene;
    scene::Material &material = scene.materials.emplace_back();
    material[PARAMETER_specular_weight].value = Vec3::Zero();
    material[PARAMETER_subsurface_weight].value = Vec3::Ones();
    material[PARAMETER_subsurface_color].value = medium.color;
    material[PARAMETER_subsurface_radius].value = Vec3::Ones();
    material[PARAMETER_subsurface_radius_scale].value = medium.radius_scale;
    material[PARAMETER_subsurface_scatter_anisotropy].value = Vec3::Constant(medium.anisotropy);
    material[PARAMETER_subsurface_bleed].value = Vec3::Constant(medium.bleed);
    scene.objects.push_back({.name = "body", .mesh = std::move(mesh)});
    scene.camera.kind = CAMERA_ORTHOGRAPHIC;
    scene.camera.position = {0, 0, 100};
    scene.camera.height = height;
    scene.image = {pixels, pixels};
    scene.render.max_depth = 1; // the ray after the exit is the last
    return scene;
}

/// A box below z = 0, seen from above.
scene::Scene box(const Medium &medium, double width, double thickness) {
    return scene_of(medium, scene::make_box({-width / 2, -width / 2, -thickness}, {width / 2, width / 2, 0}), patch);
}

/// A block so large that no light of its middle gets to its sides: of walks in one of 12 diffusion lengths a few do,
/// with weights to 15, since guides know nothing of sides.
scene::Scene half_space(const Medium &medium) {
    const scene::Scene unit = box(medium, 1, 1);
    const double size = std::max(4000., 60 * render::diffusion_length(unit, unit.materials[0]).maxCoeff());
    return box(medium, size, size);
}

scene::Scene lit_from_everywhere(scene::Scene scene) {
    scene.lights.emplace_back(); // an environment of radiance 1, not seen by the camera
    return scene;
}

scene::Scene lit_from_behind(scene::Scene scene) {
    scene::Light &light = scene.lights.emplace_back();
    light.kind = LIGHT_DIRECTIONAL;
    light.direction = {0, 0, 1};
    light.radiance = Vec3::Constant(std::numbers::pi); // a white surface shows radiance 1
    return scene;
}

scene::Scene sphere(const Medium &medium, double radius) {
    return scene_of(medium, scene::make_sphere({0, 0, 0}, radius, 128), 2 * radius);
}

/// A model in its own material, but for g and bleed.
scene::Scene load_model(const std::string &name, const std::string &material, const Medium &medium) {
    const std::string set = "materials." + material + ".subsurface_";
    scene::Scene scene = io::load_scene(fmt::format("{}/{}/{}.json", NACRE_SCENES, name, name),
                                        {{set + "scatter_anisotropy", fmt::format("{}", medium.anisotropy)},
                                         {set + "bleed", fmt::format("{}", medium.bleed)}});
    scene.image = {pixels, pixels * scene.image.height / scene.image.width};
    return scene;
}

/// The same in the medium that the other bodies are of, without a reflecting layer, as they are.
scene::Scene in_medium(scene::Scene scene, const std::string &material, const Medium &medium) {
    for (scene::Material &m : scene.materials) {
        if (m.name != material) continue;
        m[PARAMETER_specular_weight] = {};
        m[PARAMETER_subsurface_color] = {medium.color};
        m[PARAMETER_subsurface_radius_scale] = {medium.radius_scale};
    }
    return scene;
}

/// Files of the head are not in this repository.
bool has_head() {
    try {
        load_model("head", "skin", {});
        return true;
    } catch (const Error &) {
        return false;
    }
}

} // namespace

std::vector<Medium> media(bool full) {
    std::vector<Medium> colors = {{"skin", {.8, .5, .4}, {1, .35, .2}}};
    for (const double grey : {.02, .2, .5, .8, .95, .98})
        colors.push_back({fmt::format("grey{:g}", grey), Vec3::Constant(grey), {1, 1, 1}});
    std::vector<Medium> all;
    for (const Medium &color : colors)
        for (const double g : {-.3, 0., .5, .8, .95})
            for (const double bleed : {0., .5, 1.}) {
                const bool skin = color.name == "skin", base = g == 0 || g == .8;
                if (!full && !(skin ? base || bleed == 0 : base && bleed == 0)) continue;
                all.push_back({color.name, color.color, color.radius_scale, g, bleed});
            }
    return all;
}

std::vector<Scenario> body_scenarios(bool full) {
    std::vector<Scenario> all;
    const auto add = [&](const char *body, const Medium &medium, scene::Scene scene, bool flat) {
        all.push_back({name_of(body, medium), std::move(scene), flat});
    };
    for (const Medium &m : media(full)) {
        add("half_space", m, lit_from_everywhere(half_space(m)), true);
        add("slab1_both", m, lit_from_everywhere(box(m, slab_width, 1)), true);
        add("slab1_behind", m, lit_from_behind(box(m, slab_width, 1)), true);
        add("slab5_both", m, lit_from_everywhere(box(m, slab_width, 5)), true);
        add("slab5_behind", m, lit_from_behind(box(m, slab_width, 5)), true);
        add("sphere3", m, lit_from_everywhere(sphere(m, 3)), false);
        add("sphere30", m, lit_from_everywhere(sphere(m, 30)), false);
    }
    return all;
}

std::vector<Scenario> model_scenarios(bool full) {
    const bool head = has_head();
    const std::string name = head ? "head" : "bear", material = head ? "skin" : "gummy";
    std::vector<Scenario> all;
    for (const Medium &medium : media(full)) {
        if (medium.name != "skin") continue; // but in its matte medium the model has a colour of its own
        const scene::Scene scene = load_model(name, material, medium);
        all.push_back({name_of((name + "_matte").c_str(), medium), in_medium(scene, material, medium)});
        all.push_back({fmt::format("{}/{}/g{:g}/b{:g}", name, material, medium.anisotropy, medium.bleed), scene});
    }
    return all;
}

scene::Scene without_media(scene::Scene scene) {
    for (scene::Material &material : scene.materials) {
        if (!scene::scatters_below(material)) continue;
        material[PARAMETER_base_color] = material[PARAMETER_subsurface_color];
        material[PARAMETER_subsurface_weight] = {};
    }
    return scene;
}

} // namespace nacre::bench
