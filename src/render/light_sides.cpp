#include "render/light_sides.h"
#include "scene/features.h"
#include <algorithm>
#include <random>

namespace nacre::render {
namespace {

using namespace shared;

/// An error of a tenth in a ratio of lights costs nothing; few points of large objects may miss a spot of light.
constexpr int points_per_object = 512;

float4 to_float4(const Vec3f &v, float w) { return {v.x(), v.y(), v.z(), w}; }

/// Whether a surface turns towards the camera.
bool faces(const Camera &camera, const float4 &point, const float4 &normal) {
    const float4 &d = camera.forward, &p = camera.position;
    if (camera.kind == CAMERA_ORTHOGRAPHIC) return normal.x * d.x + normal.y * d.y + normal.z * d.z < 0;
    return normal.x * (p.x - point.x) + normal.y * (p.y - point.y) + normal.z * (p.z - point.z) > 0;
}

} // namespace

bool has_sides(const scene::Scene &scene) {
    return std::any_of(scene.lights.begin(), scene.lights.end(),
                       [](const scene::Light &light) { return light.kind != LIGHT_ENVIRONMENT; }) ||
           (scene::features(scene, false, false) & FEATURE_EMISSION);
}

bool is_measured(const Object &object) { return object.guided > 0 || object.control_thickness < GUIDE_THICK; }

std::vector<float4> light_points(const scene::Scene &scene, const Geometry &geometry) {
    std::vector<float4> points;
    if (!has_sides(scene)) return points;
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(0, 1);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        if (!is_measured(geometry.objects[i])) continue;
        const std::span<const accel::Triangle> triangles(geometry.world.data() + geometry.objects[i].first_primitive,
                                                         scene.objects[i].mesh.triangles.size());
        std::vector<double> areas;
        for (const accel::Triangle &t : triangles)
            areas.push_back(double((t.v[1] - t.v[0]).cross(t.v[2] - t.v[0]).norm()));
        std::discrete_distribution<std::size_t> by_area(areas.begin(), areas.end());
        for (int k = 0; k < points_per_object; ++k) {
            const accel::Triangle &t = triangles[by_area(random)];
            const float root = std::sqrt(unit(random)), b = unit(random);
            const Vec3f at = (1 - root) * t.v[0] + root * (1 - b) * t.v[1] + root * b * t.v[2];
            points.push_back(to_float4(at, float(i)));
            points.push_back(to_float4((t.v[1] - t.v[0]).cross(t.v[2] - t.v[0]).normalized(), 0));
        }
    }
    return points;
}

void measure_light_sides(const device::Device &device, const device::Program &program, const DeviceScene &scene,
                         device::Recorder &recorder) {
    const std::uint32_t count = std::uint32_t(scene.light_points.size() / 2);
    if (count == 0) return;
    cl::Kernel kernel(program.program, "light_points");
    const cl::Buffer points(device.context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, 2 * count * sizeof(float4),
                            const_cast<float4 *>(scene.light_points.data()));
    const cl::Buffer light(device.context, CL_MEM_WRITE_ONLY, count * sizeof(float));
    cl_uint argument = scene.bind(kernel);
    kernel.setArg(argument++, points);
    kernel.setArg(argument++, count);
    kernel.setArg(argument++, light);
    recorder.run(device, kernel, count);
    std::vector<float> irradiance(count);
    device.queue.enqueueReadBuffer(light, true, 0, count * sizeof(float), irradiance.data());

    // Of a point's light each axis takes the share that it has in the normal: n_x^2 + n_y^2 + n_z^2 = 1.
    struct Side {
        double light = 0, weight = 0;
        float mean() const { return weight > 0 ? float(light / weight) : 0; }
    };
    std::vector<std::array<Side, 6>> sides(scene.frame.object_count);
    for (std::uint32_t k = 0; k < count; ++k) {
        const float4 &normal = scene.light_points[2 * k + 1];
        const float n[] = {normal.x, normal.y, normal.z};
        for (int axis = 0; axis < 3; ++axis) {
            Side &side = sides[std::size_t(scene.light_points[2 * k].w)][axis + (n[axis] > 0 ? 0 : 3)];
            side.light += double(n[axis] * n[axis] * irradiance[k]);
            side.weight += double(n[axis] * n[axis]);
        }
    }
    std::vector<LightSides> found;
    for (const std::array<Side, 6> &s : sides)
        found.push_back({{s[0].mean(), s[1].mean(), s[2].mean(), 0}, {s[3].mean(), s[4].mean(), s[5].mean(), 0}});
    device.queue.enqueueWriteBuffer(scene.sides().buffer, true, 0, found.size() * sizeof(LightSides), found.data());

    uint lit_in_sight = 0;
    for (std::uint32_t k = 0; k < count; ++k)
        if (irradiance[k] > 0 && faces(scene.frame.camera, scene.light_points[2 * k], scene.light_points[2 * k + 1]))
            lit_in_sight = 1;
    if (scene.frame.lone_rays > lit_in_sight)
        device.queue.enqueueWriteBuffer(scene.buffers[0].buffer, true, offsetof(Frame, lone_rays), sizeof lit_in_sight,
                                        &lit_in_sight);
}

} // namespace nacre::render
