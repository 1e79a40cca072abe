#include "io/read_scene.h"
#include "io/read_material.h"
#include <algorithm>

namespace nacre::io {

namespace {

constexpr Choice channel_samplings[] = {{"hero", shared::CHANNEL_HERO},
                                        {"single", shared::CHANNEL_SINGLE},
                                        {"albedo", shared::CHANNEL_ALBEDO},
                                        {"throughput", shared::CHANNEL_THROUGHPUT}};
constexpr Choice guidings[] = {
    {"eigen", shared::GUIDING_EIGEN}, {"none", shared::GUIDING_NONE}, {"dwivedi", shared::GUIDING_DWIVEDI}};

} // namespace

void read_settings(Fields &root, Reading &reading) {
    if (const Json *tree = root.find("image")) {
        Fields image(*tree, "image", "image", reading.source);
        image.read("width", reading.scene.image.width);
        image.read("height", reading.scene.image.height);
        image.finish();
    }
    if (const Json *tree = root.find("render")) {
        scene::RenderSettings &settings = reading.scene.render;
        Fields render(*tree, "render", "render", reading.source);
        render.read("spp", settings.spp);
        render.read("seed", settings.seed);
        render.read("max_depth", settings.max_depth);
        render.read("exposure", settings.exposure);
        render.read_choice("channel_sampling", channel_samplings, settings.channel_sampling);
        render.read_choice("guiding", guidings, settings.guiding);
        render.read("clearance", settings.clearance);
        render.read("control_variate", settings.control);
        render.finish();
    }
    if (const Json *tree = root.find("device")) {
        Fields device(*tree, "device", "device", reading.source);
        device.read("lanes", reading.scene.lanes);
        const int lanes = reading.scene.lanes;
        if (lanes != 0 && lanes != 1 && lanes != 4 && lanes != 8 && lanes != 16)
            device.fail("lanes", "must be 1, 4, 8 or 16, or 0 for what suits the device");
        device.finish();
    }
}

void read_materials(const Json *tree, Reading &reading) {
    if (!tree) return;
    const Fields section(*tree, "materials", "materials", reading.source); // checks that it is an object
    std::vector<scene::Material> &materials = reading.scene.materials;
    for (const auto &item : tree->items()) {
        auto material = std::find_if(materials.begin(), materials.end(),
                                     [&](const scene::Material &m) { return m.name == item.key(); });
        if (material == materials.end()) {
            material = materials.emplace(materials.end());
            material->name = item.key();
        }
        read_material(item.value(), section.path(item.key()), reading.source, reading.maps, *material);
    }
}

void read_scene(const Json &tree, bool with_objects, Reading &reading) {
    Fields root(tree, "", "scene", reading.source);
    read_settings(root, reading);
    read_materials(root.find("materials"), reading);
    if (with_objects) read_objects(root.find("objects"), reading);
    read_camera(root.find("camera"), reading);
    read_lights(root.find("lights"), reading);
    root.finish();
}

} // namespace nacre::io
