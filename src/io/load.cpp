#include "io/load.h"
#include "base/error.h"
#include "io/defaults.h"
#include "io/extension.h"
#include "io/find_file.h"
#include "io/gltf.h"
#include "io/override.h"
#include "io/read_scene.h"
#include <algorithm>

namespace nacre::io {

std::string extension_of(const std::filesystem::path &file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

namespace {

void load_json(Source &source, const std::vector<Override> &overrides, Reading &reading) {
    Json tree = parse_json(read_file(source.file), source.file.string());
    if (!tree.is_object()) source.fail("", "expected an object, got " + describe(tree));
    if (!tree.contains("lights")) tree["lights"] = Json::array({{{"type", "environment"}, {"radiance", 1}}});
    apply_overrides(tree, overrides, source);
    read_scene(tree, true, reading);
}

void load_gltf(Source &source, const std::vector<Override> &overrides, Reading &reading) {
    Json tree = load_gltf_scene(source.file, reading.scene, reading.maps);
    apply_overrides(tree, overrides, source);
    read_scene(tree, false, reading);
}

// Light and skin follow the size of the object, which `--set objects…` may change: so objects are read first.
void load_bare_mesh(Source &source, const std::vector<Override> &overrides, Reading &reading) {
    Json objects = Json::object();
    objects["objects"] = Json::array({{{"mesh", source.file.filename().string()}, {"material", "skin"}}});
    std::vector<Override> of_objects = overrides, others;
    std::copy_if(overrides.begin(), overrides.end(), std::back_inserter(others),
                 [](const Override &assignment) { return !assignment.path.starts_with("objects."); });
    std::erase_if(of_objects, [](const Override &assignment) { return !assignment.path.starts_with("objects."); });
    apply_overrides(objects, of_objects, source);
    reading.scene.materials.emplace_back().name = "skin";
    read_objects(&objects["objects"], reading);

    const scene::Bounds box = scene::bounds(reading.scene.objects);
    Json tree = Json::object();
    tree["materials"]["skin"] = default_skin(box);
    tree["lights"] = default_lights(box);
    apply_overrides(tree, others, source);
    read_scene(tree, false, reading);
}

} // namespace

scene::Scene load_scene(const std::filesystem::path &file, const std::vector<Override> &overrides,
                        const std::string &from) {
    scene::Scene scene;
    scene.file = file.string();
    Source source{file, {}, from};
    Maps maps(scene);
    Reading reading{scene, source, maps};
    const std::string extension = extension_of(file);
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) input_error(file.string(), "there is no such file");
    if (extension == ".json")
        load_json(source, overrides, reading);
    else if (extension == ".gltf" || extension == ".glb")
        load_gltf(source, overrides, reading);
    else if (extension == ".obj" || extension == ".ply")
        load_bare_mesh(source, overrides, reading);
    else
        input_error(file.string(), "'{}' is not a scene nacre reads: .json .gltf .glb .obj .ply", extension);
    return scene;
}

} // namespace nacre::io
