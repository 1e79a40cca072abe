#pragma once
#include "accel/bvh.h"
#include "scene/normalise.h"
#include "scene/scene.h"
#include "shared/features.h"
#include "shared/scene.h"
#include <vector>

namespace nacre::render {

/// Leaf blocks of a tree.
struct Blocks {
    std::uint32_t first = 0, count = 0;
};

/// The objects of a scene as kernels read them; primitives are counted from object to object.
struct Geometry {
    accel::Bvh bvh;
    std::uint32_t root = 0;             // of the tree over everything
    std::vector<accel::Triangle> world; // by primitive, on the host only
    std::vector<shared::Object> objects;
    std::vector<Blocks> walk_blocks;     // of the tree of each object with subsurface scattering
    std::vector<shared::uint> triangles; // 3 vertices per primitive, where they have normals or uvs
    std::vector<float> normals;          // 3 per vertex, where the features have SMOOTH; 0: use the geometric one
    std::vector<float> uvs;              // 2 per vertex, where they have TEXTURES
    std::vector<std::uint8_t> clearance; // fields of the objects, one after the other
};

/// Builds the trees: one over everything, and one for each object with subsurface scattering unless it is alone.
Geometry build_geometry(const scene::Scene &scene, const scene::Frame &frame, std::uint32_t features, int bvh_width);

} // namespace nacre::render
