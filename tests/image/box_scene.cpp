#include "image/box_scene.h"
#include "patch/patch.h"
#include <fmt/format.h>

namespace nacre {
namespace {

std::string scene_text(const Medium &m, double radius, double camera_height, double camera_distance,
                       const std::string &objects) {
    return fmt::format(
        R"({{"camera": {{"type": "orthographic", "position": [0, 0, {}], "target": [0, 0, 0], "height": {}}},
             "image": {{"width": 64, "height": 64}}, "render": {{"spp": 16, "max_depth": 0}},
             "materials": {{
               "medium": {{"subsurface_weight": 1, "subsurface_albedo": [{}, {}, {}], "subsurface_radius": {},
                           "subsurface_radius_scale": 1, "subsurface_scatter_anisotropy": {}, "subsurface_bleed": {},
                           "subsurface_entry": "{}", "subsurface_flight": "{}", "specular_weight": 0}},
               "black": {{"base_color": 0, "specular_weight": 0}}}},
             "objects": [{}],
             "lights": [{{"type": "environment", "radiance": 1}}]}})",
        camera_distance, camera_height, m.albedo[0], m.albedo[1], m.albedo[2], radius, m.g, m.bleed, m.entry, m.flight,
        objects);
}

} // namespace

scene::Scene half_space(const Medium &medium, double thickness) {
    const scene::Scene scene = plain_box(medium, thickness);
    return patch::patch_scene(scene.materials[scene.objects[0].material], thickness, 64);
}

scene::Scene plain_box(const Medium &medium, double thickness) {
    return scene_of(scene_text(medium, 2 / thickness, 0.1, 3, R"({"box": {}, "material": "medium"})"));
}

scene::Scene slab(const Medium &medium, double tau, bool plate) {
    std::string objects = R"({"box": {"min": [-100, -100, -0.2], "max": [100, 100, 0]}, "material": "medium"})";
    if (plate) objects += R"(, {"box": {"min": [-100, -100, -0.4], "max": [100, 100, -0.3]}, "material": "black"})";
    return scene_of(scene_text(medium, 0.2 / tau, 1, 1, objects));
}

scene::Scene ball(const Medium &medium, double tau) {
    return scene_of(
        scene_text(medium, 1 / tau, 1.4, 3, R"({"sphere": {"segments": 256}, "material": "medium", "smooth": false})"));
}

} // namespace nacre
