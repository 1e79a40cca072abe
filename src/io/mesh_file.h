#pragma once
#include "scene/mesh.h"
#include <filesystem>
#include <string>
#include <vector>

namespace nacre::io {

/// Reads Wavefront OBJ: all its groups as one mesh. Its materials are not read. Throws Error{Exit::input}.
scene::Mesh load_obj(const std::filesystem::path &file, std::vector<std::string> &warnings);

/// Reads Stanford PLY, ASCII or binary of either byte order: vertices with normals and uvs, faces as triangles or
/// convex polygons. Throws Error{Exit::input}.
scene::Mesh load_ply(const std::filesystem::path &file);

/// Throws Error{Exit::input} where a mesh has no triangles, an index out of range, or a position or uv that is
/// not finite.
void check_mesh(const scene::Mesh &mesh, const std::string &subject);

} // namespace nacre::io
