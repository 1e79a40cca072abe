#pragma once
#include "scene/scene.h"
#include <filesystem>
#include <string>
#include <vector>

namespace nacre::io {

/// One `--set path=value`: "render.spp" "16", "materials.skin.subsurface_radius" "0.1", "objects.0.material" "\"wax\"".
struct Override {
    std::string path, value;
};

/// Reads any scene nacre knows: nacre JSON, glTF (.gltf, .glb), a bare mesh (.obj, .ply; default camera, light and
/// skin). Files named by it are looked for beside it, then in the folders of NACRE_ASSETS (a ':' separated list).
/// Throws Error{Exit::input}; MissingFile, which is one, where a file that the scene names is not there. Errors of
/// `overrides` have the subject `from`. `Scene::warnings` names what was read but not used.
scene::Scene load_scene(const std::filesystem::path &file, const std::vector<Override> &overrides = {},
                        const std::string &from = "--set");

} // namespace nacre::io
