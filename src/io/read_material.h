#pragma once
#include "io/fields.h"
#include "io/maps.h"

namespace nacre::io {

/// Reads the fields of a material at `path` over `material`: what `tree` does not name stays as it is.
/// Throws Error{Exit::input}.
void read_material(const Json &tree, const std::string &path, const Source &source, Maps &maps,
                   scene::Material &material);

} // namespace nacre::io
