#include "oracle/reference_rays.h"
#include "base/error.h"
#include <cmath>

namespace nacre::reference {
namespace {

/// Where the ray meets the plane of a triangle: NaN or infinite along it.
double distance_to(const Triangle &v, const Ray &ray) {
    const Vec3 normal = (v[1] - v[0]).cross(v[2] - v[0]);
    return normal.dot(v[0] - ray.origin) / normal.dot(ray.direction);
}

Vec3 weights_at(const Triangle &v, const Vec3 &p) {
    const Vec3 normal = (v[1] - v[0]).cross(v[2] - v[0]);
    Vec3 w(normal.dot((v[2] - v[1]).cross(p - v[1])), normal.dot((v[0] - v[2]).cross(p - v[2])),
           normal.dot((v[1] - v[0]).cross(p - v[0])));
    w = w.cwiseMax(0); // Embree's float may see a point beside the triangle in it
    return w / w.sum();
}

/// What Embree's filter has to know: the ray in double, and the range of t that counts.
struct Query {
    RTCIntersectContext context; // first: Embree hands back its address
    const std::vector<Triangle> *triangles;
    const Ray *ray;
    double after, before;
};

/// Embree proposes triangles, double decides.
void decide(const RTCFilterFunctionNArguments *arguments) {
    const auto *query = reinterpret_cast<const Query *>(arguments->context);
    const std::uint32_t triangle = RTCHitN_primID(arguments->hit, 1, 0);
    const double t = distance_to((*query->triangles)[triangle], *query->ray);
    if (triangle == query->ray->on || !(t > query->after && t < query->before)) arguments->valid[0] = 0;
}

/// Embree starts this much before the ray and goes on this much after it, so that its rounding hides no triangle.
constexpr double margin = 1e-5;

} // namespace

Rays::Rays(std::vector<Triangle> given)
    : triangles(std::move(given)), device(rtcNewDevice(nullptr)), scene(rtcNewScene(device.get())) {
    rtcSetSceneFlags(scene.get(), RTCSceneFlags(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
    RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto *positions = static_cast<float *>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * triangles.size()));
    auto *corners = static_cast<std::uint32_t *>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), triangles.size()));
    for (std::size_t i = 0; i < 3 * triangles.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) positions[3 * i + axis] = float(triangles[i / 3][i % 3][axis]);
        corners[i] = std::uint32_t(i);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene.get());
    if (rtcGetDeviceError(device.get()) != RTC_ERROR_NONE)
        throw Error(Exit::failed, "Embree", "cannot build the reference's scene");
}

std::optional<Hit> Rays::closest(const Ray &ray, double after, double before) const {
    Query query{{}, &triangles, &ray, after, before};
    rtcInitIntersectContext(&query.context);
    query.context.filter = decide;
    const Vec3f start = (ray.origin - margin * ray.direction).cast<float>(), along = ray.direction.cast<float>();
    RTCRayHit found{};
    found.ray.org_x = start.x();
    found.ray.org_y = start.y();
    found.ray.org_z = start.z();
    found.ray.dir_x = along.x();
    found.ray.dir_y = along.y();
    found.ray.dir_z = along.z();
    found.ray.tnear = float(after);
    found.ray.tfar = float(before + 2 * margin);
    found.ray.mask = ~0u;
    found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    found.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene.get(), &query.context, &found);
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    const Triangle &v = triangles[found.hit.primID];
    const double t = distance_to(v, ray);
    return Hit{t, found.hit.primID, weights_at(v, ray.origin + t * ray.direction)};
}

} // namespace nacre::reference
