#pragma once
#include "base/vector.h"
#include "io/gltf_file.h"

namespace nacre::io {

/// A node of the active scene and its place in the world.
struct GltfNode {
    int index = 0;
    Transform to_world;
};

/// All nodes of the active scene (without one: of the file), parents before children.
/// Throws Error{Exit::input} for indices out of range and for nodes that are their own ancestors.
std::vector<GltfNode> place_nodes(const GltfFile &file);

} // namespace nacre::io
