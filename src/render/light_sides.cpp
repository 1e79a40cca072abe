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

/// Cosine with which the camera sees a surface; none where it turns away.
double seen(const Camera &camera, const float4 &point, const float4 &normal) {
    const auto vector = [](const float4 &v) { return Vec3(v.x, v.y, v.z); };
    const Vec3 towards = camera.kind == CAMERA_ORTHOGRAPHIC ? Vec3(-vector(camera.forward))
                                                            : Vec3(vector(camera.position) - vector(point));
    return std::max(0., vector(normal).dot(towards.normalized()));
}

/// Whether the camera sees enough of the light on an object: a quarter of what it sees has .3 times as much as all of
/// it has in the mean. Bear and head have .5 to .8 of that, balls before a lamp none, the bear with one behind it .05.
/// There twins are no use, and take a third of the time (1.4 times as long with them, at the same noise).
struct InSight {
    double light = 0, count = 0, seen = 0, lit = 0;
    bool enough() const { return lit > 0.25 * seen; }
};

} // namespace

bool has_sides(const scene::Scene &scene) {
    return std::any_of(scene.lights.begin(), scene.lights.end(),
                       [](const scene::Light &light) { return light.kind != LIGHT_ENVIRONMENT; }) ||
           (scene::features(scene, false, false) & FEATURE_EMISSION);
}

bool is_measured(const Object &object) {
    return object.guided > 0 || object.control_thickness < GUIDE_THICK || object.plate;
}

double far_light(const LightSides &sides, const Vec3 &normal) {
    const float *const lower = &sides.lower.x, *const upper = &sides.upper.x;
    double near = 0, far = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double share = normal[axis] * normal[axis];
        near += share * double(normal[axis] > 0 ? upper[axis] : lower[axis]);
        far += share * double(normal[axis] > 0 ? lower[axis] : upper[axis]);
    }
    if (!(near + far > 0)) return 1;
    return std::clamp(far / near, double(GUIDE_LEAST_LIGHT), 1 / double(GUIDE_LEAST_LIGHT));
}

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

std::vector<LightSides> measure_light(const device::Device &device, const device::Program &program,
                                      const DeviceScene &scene, device::Recorder &recorder) {
    const std::uint32_t count = std::uint32_t(scene.light_points.size() / 2);
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
    std::vector<InSight> in_sight(scene.frame.object_count);
    const auto object_of = [&](std::uint32_t k) { return std::size_t(scene.light_points[2 * k].w); };
    for (std::uint32_t k = 0; k < count; ++k) {
        in_sight[object_of(k)].light += double(irradiance[k]);
        in_sight[object_of(k)].count += 1;
    }
    for (std::uint32_t k = 0; k < count; ++k) {
        InSight &object = in_sight[object_of(k)];
        const double cosine = seen(scene.frame.camera, scene.light_points[2 * k], scene.light_points[2 * k + 1]);
        object.seen += cosine;
        if (double(irradiance[k]) > 0.3 * object.light / object.count) object.lit += cosine;
    }
    std::vector<LightSides> found;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const auto &s = sides[i];
        found.push_back({{s[0].mean(), s[1].mean(), s[2].mean(), 0},
                         {s[3].mean(), s[4].mean(), s[5].mean(), 0},
                         0,
                         0,
                         in_sight[i].enough(),
                         0});
    }
    return found;
}

} // namespace nacre::render
