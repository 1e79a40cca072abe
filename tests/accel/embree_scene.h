#pragma once
#include "accel/probe.h"
#include <embree3/rtcore.h>
#include <memory>
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace nacre {

/// Embree's manual asks for flushed denormals; the thread's former state comes back at the end.
class FlushDenormals {
#if defined(__x86_64__)
  public:
    FlushDenormals() { _mm_setcsr(before | 0x8040); } // FTZ, DAZ
    ~FlushDenormals() { _mm_setcsr(before); }

  private:
    const unsigned before = _mm_getcsr();
#endif
};

/// Embree's own scene over the same triangles, and its rays one by one: the reference for hits and for speed.
class EmbreeScene {
  public:
    EmbreeScene(std::span<const accel::Triangle> triangles, bool robust,
                RTCBuildQuality quality = RTC_BUILD_QUALITY_MEDIUM);

    /// On the calling thread, with denormals flushed as Embree asks for. block and slot of the hits are not set.
    void closest(std::span<const ProbeRay> rays, std::span<ProbeHit> hits) const;

    /// For rays of the caller's own making.
    RTCScene handle() const { return scene.get(); }

  private:
    struct Release {
        void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
        void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    };
    std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release> device;
    std::unique_ptr<std::remove_pointer_t<RTCScene>, Release> scene;
};

} // namespace nacre
