#pragma once
#include "io/gltf_file.h"
#include "scene/mesh.h"
#include <map>

namespace nacre::io {

/// The triangles of mesh `index` in its own space, by material (-1: none). Throws Error{Exit::input}.
std::map<int, scene::Mesh> read_gltf_mesh(const GltfFile &file, int index, std::vector<std::string> &warnings);

} // namespace nacre::io
