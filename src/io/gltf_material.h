#pragma once
#include "io/gltf_file.h"
#include "io/maps.h"

namespace nacre::io {

/// Material `index` of `file`. `fallback_radius`: mean free path where the file gives no extinction.
/// Throws Error{Exit::input}.
scene::Material read_gltf_material(const GltfFile &file, int index, double fallback_radius, Maps &maps,
                                   std::vector<std::string> &warnings);

/// Reads a textureInfo into scene textures; `channel` -1: all (a colour, a normal). Returns its index.
/// Throws Error{Exit::input}.
int read_gltf_texture(const GltfFile &file, const Json &info, ColorSpace space, int channel, const std::string &where,
                      Maps &maps, std::vector<std::string> &warnings);

} // namespace nacre::io
