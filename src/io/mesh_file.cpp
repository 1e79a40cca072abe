#include "io/mesh_file.h"
#include "base/error.h"
#include <cmath>

namespace nacre::io {

void check_mesh(const scene::Mesh &mesh, const std::string &subject) {
    constexpr double largest = 1e30; // as for every length in a scene: see ranges.cpp
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        if (const Vec3 &p = mesh.positions[i]; !(p.cwiseAbs().maxCoeff() <= largest) || !p.allFinite())
            input_error(subject, "vertex {} is at ({}, {}, {}), must be finite and within {}", i, p.x(), p.y(), p.z(),
                        largest);
    for (std::size_t i = 0; i < mesh.uvs.size(); ++i)
        if (!mesh.uvs[i].allFinite()) input_error(subject, "the uv of vertex {} is not finite", i);
    if (mesh.triangles.empty()) input_error(subject, "has no triangles");
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (const std::uint32_t vertex : mesh.triangles[i])
            if (vertex >= mesh.positions.size())
                input_error(subject, "triangle {} names vertex {}, there are {}", i, vertex, mesh.positions.size());
}

} // namespace nacre::io
