#include "oracle/reference_world.h"
#include "oracle/reference_normal.h"
#include "oracle/reference_texture.h"
#include <algorithm>

namespace nacre::reference {
namespace {

using namespace shared;

std::vector<Triangle> triangles_of(const scene::Object &object, const scene::Frame &units) {
    std::vector<Triangle> triangles;
    for (const auto &corners : object.mesh.triangles) {
        Triangle &triangle = triangles.emplace_back();
        for (int k = 0; k < 3; ++k) triangle[k] = units.point(object.mesh.positions[corners[k]]);
    }
    return triangles;
}

std::vector<Triangle> triangles_of(const scene::Scene &scene, const scene::Frame &units) {
    std::vector<Triangle> all;
    for (const scene::Object &object : scene.objects) {
        const std::vector<Triangle> own = triangles_of(object, units);
        all.insert(all.end(), own.begin(), own.end());
    }
    return all;
}

std::vector<Sky> skies_of(const scene::Scene &scene) {
    std::vector<Sky> skies;
    for (const scene::Light &light : scene.lights)
        if (light.kind == LIGHT_ENVIRONMENT_IMAGE) skies.emplace_back(light);
    return skies;
}

} // namespace

World::World(const scene::Scene &given)
    : scene(given), units(scene::frame_of(given)), skies(skies_of(given)), rays(triangles_of(given, units)) {
    std::uint32_t count = 0;
    for (const scene::Object &object : scene.objects) {
        first.push_back(count);
        count += std::uint32_t(object.mesh.triangles.size());
        const bool walks = scene::walks_below(scene.materials[object.material]);
        bodies.push_back(walks ? std::make_unique<Rays>(triangles_of(object, units)) : nullptr);
    }
}

Surface World::surface(const Hit &hit) const {
    Surface surface;
    surface.triangle = hit.triangle;
    surface.object = std::uint32_t(std::upper_bound(first.begin(), first.end(), hit.triangle) - first.begin() - 1);
    const Triangle &v = rays[hit.triangle];
    const scene::Mesh &mesh = scene.objects[surface.object].mesh;
    const auto &corners = mesh.triangles[hit.triangle - first[surface.object]];
    surface.position = hit.weights[0] * v[0] + hit.weights[1] * v[1] + hit.weights[2] * v[2];
    surface.geometric = (v[1] - v[0]).cross(v[2] - v[0]).normalized();
    surface.shading = surface.geometric;
    const auto interpolated = [&](const auto &of_vertices) {
        return (hit.weights[0] * of_vertices[corners[0]].template cast<double>() +
                hit.weights[1] * of_vertices[corners[1]].template cast<double>() +
                hit.weights[2] * of_vertices[corners[2]].template cast<double>())
            .eval();
    };
    if (!mesh.uvs.empty()) surface.uv = interpolated(mesh.uvs);
    if (!mesh.normals.empty()) {
        const Vec3 normal = interpolated(mesh.normals);
        if (normal.norm() > 0) surface.shading = normal.normalized();
    }
    const int map = material(surface)[PARAMETER_geometry_normal].texture;
    if (map >= 0) {
        const auto uv = [&](int k) -> Vec2 { return mesh.uvs[corners[std::size_t(k)]].cast<double>(); };
        surface.shading =
            mapped_normal(scene, std::uint32_t(map), surface.uv, surface.shading, v, {uv(0), uv(1), uv(2)});
    }
    if (surface.shading.dot(surface.geometric) <= 0) surface.shading = surface.geometric;
    return surface;
}

double World::value(const Surface &surface, Parameter parameter, int channel) const {
    const scene::Value &value = material(surface)[parameter];
    if (value.texture < 0) return value.value[channel];
    return texture_at(scene, std::uint32_t(value.texture), surface.uv)[channel];
}

Medium World::medium(const Surface &surface, int channel) const {
    const scene::Material &source = material(surface);
    Medium medium;
    const double radius = value(surface, PARAMETER_subsurface_radius) / units.size;
    medium.extinction = 1 / (radius * value(surface, PARAMETER_subsurface_radius_scale, channel));
    medium.albedo = value(surface, PARAMETER_subsurface_color, channel);
    medium.g = value(surface, PARAMETER_subsurface_scatter_anisotropy, channel);
    medium.bleed = value(surface, PARAMETER_subsurface_bleed);
    medium.reciprocal = source.flight == FLIGHT_RECIPROCAL;
    medium.max_depth = source.max_depth;
    return medium;
}

} // namespace nacre::reference
