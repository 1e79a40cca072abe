#include "render/geometry.h"
#include "scene/closed.h"

namespace nacre::render {
namespace {

using namespace shared;

std::vector<accel::Triangle> world_triangles(const scene::Scene &scene, const scene::Frame &frame) {
    std::vector<accel::Triangle> triangles;
    for (const scene::Object &object : scene.objects)
        for (const auto &corner : object.mesh.triangles) {
            accel::Triangle &triangle = triangles.emplace_back();
            for (int k = 0; k < 3; ++k) triangle.v[k] = frame.point(object.mesh.positions[corner[k]]).cast<float>();
        }
    return triangles;
}

void append_vertices(const scene::Mesh &mesh, std::uint32_t features, Geometry &geometry) {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if (features & FEATURE_SMOOTH) {
            const Vec3f n = mesh.normals.empty() ? Vec3f(0, 0, 0) : mesh.normals[i];
            geometry.normals.insert(geometry.normals.end(), {n.x(), n.y(), n.z()});
        }
        if (features & FEATURE_TEXTURES) {
            const Vec2f uv = mesh.uvs.empty() ? Vec2f(0, 0) : mesh.uvs[i];
            geometry.uvs.insert(geometry.uvs.end(), {uv.x(), uv.y()});
        }
    }
}

std::uint32_t blocks_of(const accel::Bvh &bvh) {
    return std::uint32_t(bvh.blocks.size() / std::size_t(BVH_BLOCK_ROWS * bvh.width));
}

} // namespace

Geometry build_geometry(const scene::Scene &scene, const scene::Frame &frame, std::uint32_t features, int bvh_width) {
    Geometry geometry;
    geometry.bvh.width = bvh_width;
    geometry.world = world_triangles(scene, frame);
    const std::vector<accel::Triangle> &triangles = geometry.world;
    geometry.root = accel::append_tree(geometry.bvh, triangles, 0);
    std::uint32_t first_primitive = 0, first_vertex = 0;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const scene::Object &source = scene.objects[i];
        const scene::Mesh &mesh = source.mesh;
        const std::span<const accel::Triangle> own(triangles.data() + first_primitive, mesh.triangles.size());
        Object object{};
        Blocks walk_blocks{};
        object.material = source.material;
        object.first_light = NO_LIGHT;
        object.first_primitive = first_primitive;
        object.walk_root = geometry.root;
        if (scene::scatters_below(scene.materials[source.material])) {
            object.closed = scene::is_closed(mesh);
            if (scene.objects.size() > 1) {
                walk_blocks.first = blocks_of(geometry.bvh);
                object.walk_root = accel::append_tree(geometry.bvh, own, first_primitive);
            }
            walk_blocks.count = blocks_of(geometry.bvh) - walk_blocks.first;
        }
        geometry.objects.push_back(object);
        geometry.walk_blocks.push_back(walk_blocks);
        if (features & (FEATURE_SMOOTH | FEATURE_TEXTURES))
            for (const auto &corner : mesh.triangles)
                for (const std::uint32_t vertex : corner) geometry.triangles.push_back(first_vertex + vertex);
        append_vertices(mesh, features, geometry);
        first_primitive += std::uint32_t(mesh.triangles.size());
        first_vertex += std::uint32_t(mesh.positions.size());
    }
    return geometry;
}

} // namespace nacre::render
