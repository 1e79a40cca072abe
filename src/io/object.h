#pragma once
#include "scene/scene.h"
#include <optional>

namespace nacre::io {

/// A mesh from a file, made ready: transformed, without degenerate triangles, normals as `smooth` asks (unset: those
/// of the mesh, if any). Throws Error{Exit::input} with `subject` for a mesh that cannot be used.
scene::Object make_object(const std::string &name, scene::Mesh mesh, const Transform &transform,
                          std::optional<bool> smooth, const std::string &subject, std::vector<std::string> &warnings);

} // namespace nacre::io
