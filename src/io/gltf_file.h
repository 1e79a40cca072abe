#pragma once
#include "base/vector.h"
#include "io/tree.h"
#include <filesystem>
#include <tiny_gltf.h>

namespace nacre::io {

/// A glTF file: `json` as it is (materials, lights, images are read from it) and `model`, tinygltf's view of its
/// buffers, accessors, meshes, nodes and cameras.
struct GltfFile {
    std::filesystem::path path;
    std::string subject; // the path, for messages
    Json json;
    tinygltf::Model model;
};

/// Reads .gltf (with its buffers) or .glb. Throws Error{Exit::input}.
GltfFile load_gltf_file(const std::filesystem::path &path);

// Typed looks into a part of the JSON. An absent member gives `fallback` (null); a wrong type is an input error that
// names `where` and `name`.
const Json *gltf_member(const Json &object, const char *name);
double gltf_number(const Json &object, const char *name, double fallback, const std::string &where);
int gltf_index(const Json &object, const char *name, const std::string &where); // absent: -1
Vec3 gltf_color(const Json &object, const char *name, const Vec3 &fallback, const std::string &where);

/// Element `index` of the document's array `name`. Throws Error{Exit::input} where there is none.
const Json &gltf_element(const GltfFile &file, const char *name, int index);

} // namespace nacre::io
