#include "scene/merge.h"

namespace nacre::scene {

void make_faceted(Mesh &mesh) {
    Mesh faceted;
    for (auto &triangle : mesh.triangles) {
        const Vec3 &a = mesh.positions[triangle[0]], &b = mesh.positions[triangle[1]], &c = mesh.positions[triangle[2]];
        const Vec3f normal = (b - a).cross(c - a).stableNormalized().cast<float>();
        const auto first = static_cast<std::uint32_t>(faceted.positions.size());
        for (const std::uint32_t vertex : triangle) {
            faceted.positions.push_back(mesh.positions[vertex]);
            faceted.normals.push_back(normal);
            if (!mesh.uvs.empty()) faceted.uvs.push_back(mesh.uvs[vertex]);
        }
        faceted.triangles.push_back({first, first + 1, first + 2});
    }
    mesh = std::move(faceted);
}

void append(Mesh &mesh, Mesh part) {
    if (mesh.triangles.empty()) {
        mesh = std::move(part);
        return;
    }
    if (mesh.normals.empty() != part.normals.empty()) make_faceted(mesh.normals.empty() ? mesh : part);
    if (mesh.uvs.empty() != part.uvs.empty()) {
        Mesh &bare = mesh.uvs.empty() ? mesh : part;
        bare.uvs.assign(bare.positions.size(), Vec2f::Zero());
    }
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
    mesh.normals.insert(mesh.normals.end(), part.normals.begin(), part.normals.end());
    mesh.uvs.insert(mesh.uvs.end(), part.uvs.begin(), part.uvs.end());
    for (const auto &[a, b, c] : part.triangles) mesh.triangles.push_back({a + first, b + first, c + first});
}

} // namespace nacre::scene
