#include "walks/walk_scene.h"
#include "albedo/inversion.h"
#include "entries.h"
#include "render/convert.h"
#include "scene/bounds.h"
#include "scene/normalise.h"
#include "walks/embree_draws.h"
#include <cmath>

namespace nacre::bench {
namespace {

using namespace shared;

constexpr std::uint32_t samples_per_pixel = 16; // that many paths share a pixel's key

} // namespace

scene::Scene walk_scene(const scene::Mesh &mesh, double mean_free_path, double anisotropy) {
    scene::Scene scene;
    scene::Material &material = scene.materials.emplace_back();
    material[PARAMETER_specular_weight].value = Vec3::Zero();
    material[PARAMETER_subsurface_weight].value = Vec3::Ones();
    material[PARAMETER_subsurface_color].value = Vec3(0.8, 0.5, 0.4);
    material[PARAMETER_subsurface_radius].value =
        Vec3::Constant(mean_free_path * scene::bounds(mesh).sizes().maxCoeff());
    material[PARAMETER_subsurface_radius_scale].value = Vec3(1, 1, 1);
    material[PARAMETER_subsurface_scatter_anisotropy].value = Vec3::Constant(anisotropy);
    scene.objects.push_back({.name = "mesh", .mesh = mesh});
    scene.lights.emplace_back();         // an environment of radiance 1
    scene.render.guiding = GUIDING_NONE; // both sides walk classically,
    scene.render.control = false;        // and alone
    scene.render.max_depth = 1;          // the ray after the exit is the last
    return scene;
}

std::vector<accel::Triangle> walk_triangles(const scene::Scene &scene) {
    const scene::Frame units = scene::frame_of(scene);
    const scene::Mesh &mesh = scene.objects[0].mesh;
    std::vector<accel::Triangle> triangles;
    for (const auto &corner : mesh.triangles) {
        accel::Triangle &triangle = triangles.emplace_back();
        for (std::size_t k = 0; k < 3; k++) triangle.v[k] = units.point(mesh.positions[corner[k]]).cast<float>();
    }
    return triangles;
}

std::vector<Path> walk_entries(const scene::Scene &scene, std::span<const accel::Triangle> triangles,
                               std::size_t count) {
    const scene::Material &material = scene.materials[0];
    const double g = material[PARAMETER_subsurface_scatter_anisotropy].value.x();
    const Vec3 free_path =
        material[PARAMETER_subsurface_radius].value.cwiseProduct(material[PARAMETER_subsurface_radius_scale].value) /
        scene::frame_of(scene).size;
    const Vec3 albedo = material[PARAMETER_subsurface_color].value.unaryExpr(
        [g](double color) { return albedo::albedo(INVERSION_TABLE, color, {.anisotropy = g}); });
    Random random(12345);
    Entries entries(triangles);
    std::vector<Path> paths(count);
    for (std::size_t i = 0; i < count; i++) {
        const Entries::Entry entry = entries.next(random);
        Path &path = paths[i];
        path.position = render::to_float4(entry.position.cast<double>());
        path.direction = render::to_float4(entry.direction.cast<double>());
        path.throughput = {1, 1, 1, 1};
        path.radiance = {0, 0, 0, 1};
        path.weight = {1, 1, 1, 0};
        path.share = {1 / 3.0f, 1 / 3.0f, 1 / 3.0f, 0};
        path.sigma = render::to_float4(free_path.cwiseInverse());
        path.albedo = render::to_float4(albedo);
        path.anisotropy = {float(g), float(g), float(g), 0};
        path.first_number = (float(random() >> 9) + 0.5f) * 0x1p-23f; // as random_unit: never 0 or 1
        path.channel = random() % 3;
        path.slot = uint(i);
        path.pixel = uint(i) / samples_per_pixel;
        path.sample = uint(i) % samples_per_pixel;
        path.key = sampler_key(path.pixel);
        path.vertex = path.hits = path.depth = 1;
        path.state = PATH_WALK;
        path.flight = material.flight;
    }
    return paths;
}

Outcome outcome(std::span<const float4> radiance, double steps) {
    Outcome result{.steps = steps};
    for (const float4 &r : radiance) result.radiance += Vec3(r.x, r.y, r.z);
    return result;
}

} // namespace nacre::bench
