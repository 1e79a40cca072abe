#include "image/box_scene.h"
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <unistd.h>

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

// A box of 2 x 2 x 2 with its front at z = 0. The front is made of squares around squares, down to about `smallest`:
// where a walk meets a triangle is rounded by some 1e-7 of the triangle's size, which must be much less than a mean
// free path.
std::string deep_box(double smallest) {
    std::string vertices, faces;
    int rings = 0;
    const auto square = [&](double half, double z) {
        vertices += fmt::format("{0} {0} {2}\n{1} {0} {2}\n{1} {1} {2}\n{0} {1} {2}\n", -half, half, z);
    };
    // The band between squares `a` and `b`, counter-clockwise as seen from where b lies within a.
    const auto band = [&](int a, int b) {
        for (int k = 0; k < 4; ++k)
            faces += fmt::format("4 {} {} {} {}\n", a + k, a + (k + 1) % 4, b + (k + 1) % 4, b + k);
    };
    square(1, -2);
    for (double half = 1; half > smallest / 2; half /= 4) {
        square(half, 0);
        band(4 * rings, 4 * (rings + 1));
        ++rings;
    }
    const int last = 4 * rings;
    faces += fmt::format("4 3 2 1 0\n4 {} {} {} {}\n", last, last + 1, last + 2, last + 3);
    return fmt::format(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
        "element face {}\nproperty list uchar int vertex_indices\nend_header\n{}{}",
        4 * (rings + 1), 4 * rings + 2, vertices, faces);
}

} // namespace

scene::Scene half_space(const Medium &medium, double thickness) {
    const double radius = 2 / thickness;
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("nacre-box-" + std::to_string(getpid()) + ".ply");
    std::ofstream(file) << deep_box(100 * radius);
    scene::Scene scene = scene_of(scene_text(medium, radius, 100 * radius, 1,
                                             fmt::format(R"(
        {{"mesh": "{}", "material": "medium"}},
        {{"box": {{"min": [-0.001, -0.001, 1.998], "max": [0.001, 0.001, 2]}}, "material": "black"}})",
                                                         file.string())));
    std::filesystem::remove(file);
    return scene;
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
