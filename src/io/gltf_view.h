#pragma once
#include "io/gltf_nodes.h"
#include "scene/bounds.h"

namespace nacre::io {

/// The first camera of the scene as nacre JSON, aimed at the depth of `box`; null where there is none.
/// Throws Error{Exit::input}.
Json read_gltf_camera(const GltfFile &file, const std::vector<GltfNode> &nodes, const scene::Bounds &box,
                      std::vector<std::string> &warnings);

/// KHR_lights_punctual as an array of nacre JSON: candela are radiant intensity, lux are irradiance, as they are.
/// Throws Error{Exit::input}.
Json read_gltf_lights(const GltfFile &file, const std::vector<GltfNode> &nodes, std::vector<std::string> &warnings);

} // namespace nacre::io
