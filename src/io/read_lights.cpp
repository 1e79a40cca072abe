#include "io/find_file.h"
#include "io/image.h"
#include "io/read_scene.h"
#include <fmt/format.h>

namespace nacre::io {

namespace {

constexpr Choice kinds[] = {{"environment", shared::LIGHT_ENVIRONMENT},
                            {"directional", shared::LIGHT_DIRECTIONAL},
                            {"point", shared::LIGHT_POINT},
                            {"rect", shared::LIGHT_RECT}};

void read_environment(Fields &fields, scene::Light &light) {
    light.visible = true;
    std::string name;
    fields.read("image", name);
    if (!fields.find("image")) {
        fields.read_color("radiance", light.radiance);
        return;
    }
    light.kind = shared::LIGHT_ENVIRONMENT_IMAGE;
    fields.read_color("scale", light.radiance);
    fields.read("rotate", light.rotate);
    load_environment(find_file(fields.source(), fields.path("image"), name), light);
}

void read_rect(Fields &fields, scene::Light &light) {
    fields.read("center", light.position);
    fields.read("u", light.u);
    fields.read("v", light.v);
    fields.read_color("radiance", light.radiance);
    if (!(light.u.stableNormalized().cross(light.v.stableNormalized()).norm() > 1e-6))
        fields.fail("v", "u and v span no area");
}

void read_directional(Fields &fields, scene::Light &light) {
    fields.read("direction", light.direction);
    fields.read_color("irradiance", light.radiance);
    light.direction = light.direction.stableNormalized();
    if (light.direction.isZero()) fields.fail("direction", "has no length");
}

scene::Light read_light(const Json &tree, const std::string &path, const Source &source) {
    Fields fields(tree, path, "light", source);
    scene::Light light;
    if (!fields.find("type")) fields.fail("type", "is missing: environment, directional, point or rect");
    fields.read_choice("type", kinds, light.kind);
    switch (light.kind) {
    case shared::LIGHT_ENVIRONMENT: read_environment(fields, light); break;
    case shared::LIGHT_DIRECTIONAL: read_directional(fields, light); break;
    case shared::LIGHT_RECT: read_rect(fields, light); break;
    default: fields.read("position", light.position); fields.read_color("intensity", light.radiance);
    }
    fields.read("visible", light.visible);
    fields.finish();
    return light;
}

} // namespace

void read_lights(const Json *tree, Reading &reading) {
    if (!tree) return;
    if (!tree->is_array()) reading.source.fail("lights", fmt::format("expected an array, got {}", describe(*tree)));
    for (std::size_t i = 0; i < tree->size(); ++i)
        reading.scene.lights.push_back(read_light((*tree)[i], fmt::format("lights.{}", i), reading.source));
}

} // namespace nacre::io
