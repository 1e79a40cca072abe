#include "render/clearance.h"
#include "accel/clearance.h"
#include "scene/mean.h"
#include <algorithm>

namespace nacre::render {
namespace {

using namespace shared;

/// A cell takes some .2 us to build, a walk saves a microsecond or two: with fewer walks than this per cell a field
/// costs more than it brings. Of a picture's paths about every second one walks.
constexpr std::size_t cells_per_path = 4;

/// Mean free paths of a material's channels in the kernels' units; of a textured radius those of its mean.
Vec3f free_path(const scene::Scene &scene, const scene::Material &material, const scene::Frame &frame) {
    const Vec3 radius = scene::mean_color(scene, material[PARAMETER_subsurface_radius]);
    const Vec3 scale = scene::mean_color(scene, material[PARAMETER_subsurface_radius_scale]);
    return (radius.x() * scale / frame.size).cast<float>();
}

/// Gives an object its clearance field where that pays and there is room for one.
void append_clearance(const scene::Scene &scene, const scene::Frame &frame, std::span<const accel::Triangle> triangles,
                      std::size_t budget, Object &object, Geometry &geometry) {
    Eigen::AlignedBox3f box;
    for (const accel::Triangle &triangle : triangles)
        for (const Vec3f &vertex : triangle.v) box.extend(vertex);
    const float size = box.sizes().maxCoeff();
    const Vec3f path = free_path(scene, scene.materials[object.material], frame);
    if (!accel::clearance_pays(path, size)) return;
    const accel::ClearanceField field = accel::build_clearance(triangles, accel::clearance_cell(path, size), budget);
    object.clearance = field.info;
    object.clearance.first = std::uint32_t(geometry.clearance.size());
    geometry.clearance.insert(geometry.clearance.end(), field.bricks.begin(), field.bricks.end());
}

} // namespace

void add_clearance(const scene::Scene &scene, const scene::Frame &frame, std::uint64_t paths, Geometry &geometry) {
    const auto walks = [&](const scene::Object &object) { return walks_below(scene.materials[object.material]); };
    auto left = std::size_t(std::count_if(scene.objects.begin(), scene.objects.end(), walks));
    std::size_t budget = std::size_t(std::min<std::uint64_t>(accel::clearance_budget, paths * cells_per_path));
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        if (!walks(scene.objects[i])) continue;
        Object &object = geometry.objects[i];
        const std::span<const accel::Triangle> own(geometry.world.data() + object.first_primitive,
                                                   scene.objects[i].mesh.triangles.size());
        const std::size_t before = geometry.clearance.size();
        append_clearance(scene, frame, own, budget / left--, object, geometry);
        budget -= geometry.clearance.size() - before;
    }
}

} // namespace nacre::render
