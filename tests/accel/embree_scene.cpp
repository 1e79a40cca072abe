#include "accel/embree_scene.h"
#include "base/error.h"
#include <cstring>
#include <numeric>

namespace nacre {

EmbreeScene::EmbreeScene(std::span<const accel::Triangle> triangles, bool robust, RTCBuildQuality quality)
    : device(rtcNewDevice(nullptr)), scene(rtcNewScene(device.get())) {
    rtcSetSceneFlags(scene.get(), robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
    rtcSetSceneBuildQuality(scene.get(), quality);
    RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    void *positions = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3f),
                                              3 * triangles.size());
    std::memcpy(positions, triangles.data(), triangles.size_bytes());
    auto *indices = static_cast<std::uint32_t *>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), triangles.size()));
    std::iota(indices, indices + 3 * triangles.size(), 0u);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene.get());
    if (rtcGetDeviceError(device.get()) != RTC_ERROR_NONE)
        throw Error(Exit::failed, "Embree", "cannot build its scene");
}

void EmbreeScene::closest(std::span<const ProbeRay> rays, std::span<ProbeHit> hits) const {
    const FlushDenormals flush;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query;
    query.ray.time = 0;
    query.ray.mask = ~0u;
    query.ray.id = 0;
    query.ray.flags = 0;
    for (std::size_t i = 0; i < rays.size(); i++) {
        const ProbeRay &ray = rays[i];
        query.ray.org_x = ray.origin.x();
        query.ray.org_y = ray.origin.y();
        query.ray.org_z = ray.origin.z();
        query.ray.dir_x = ray.direction.x();
        query.ray.dir_y = ray.direction.y();
        query.ray.dir_z = ray.direction.z();
        query.ray.tnear = ray.t_min;
        query.ray.tfar = ray.t_max;
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        query.hit.primID = BVH_NO_PRIMITIVE;
        query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene.get(), &context, &query);
        hits[i].t = query.ray.tfar;
        hits[i].primitive = query.hit.primID;
    }
}

} // namespace nacre
