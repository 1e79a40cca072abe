#pragma once
#include "io/maps.h"
#include "io/tree.h"
#include "scene/scene.h"
#include <filesystem>
#include <optional>

namespace nacre::io {

/// All meshes of a glTF file, in the place its nodes give them, as one. Throws Error{Exit::input}.
scene::Mesh load_gltf_mesh(const std::filesystem::path &file, std::vector<std::string> &warnings);

/// The same with the file's materials: adds both to `scene`, one object per node and material, each under `transform`.
/// `name` begins the objects' names. Throws Error{Exit::input}.
void add_gltf_objects(const std::filesystem::path &file, const std::string &name, const Transform &transform,
                      std::optional<bool> smooth, scene::Scene &scene, Maps &maps);

/// A whole glTF scene: objects and materials go to `scene`; camera, lights and the names of the materials come back
/// as the nacre JSON that stands for them. Throws Error{Exit::input}.
Json load_gltf_scene(const std::filesystem::path &file, scene::Scene &scene, Maps &maps);

} // namespace nacre::io
