#include "accel/embree_scene.h"
#include "base/error.h"
#include <cstring>
#include <numeric>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace nacre {
namespace {

/// Embree's manual asks for flushed denormals; the former state comes back at the end.
class FlushDenormals {
#if defined(__x86_64__)
  public:
    FlushDenormals() { _mm_setcsr(before | 0x8040); } // FTZ, DAZ
    ~FlushDenormals() { _mm_setcsr(before); }

  private:
    const unsigned before = _mm_getcsr();
#endif
};

} // namespace

EmbreeScene::EmbreeScene(std::span<const accel::Triangle> triangles, bool robust)
    : device(rtcNewDevice(nullptr)), scene(rtcNewScene(device.get())) {
    rtcSetSceneFlags(scene.get(), robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
    rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_MEDIUM);
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
