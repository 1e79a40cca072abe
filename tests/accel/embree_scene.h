#pragma once
#include "accel/probe.h"
#include <embree3/rtcore.h>
#include <memory>

namespace nacre {

/// Embree's own scene over the same triangles, and its rays one by one: the reference for hits and for speed.
class EmbreeScene {
  public:
    EmbreeScene(std::span<const accel::Triangle> triangles, bool robust);

    /// On the calling thread, with denormals flushed as Embree asks for. block and slot of the hits are not set.
    void closest(std::span<const ProbeRay> rays, std::span<ProbeHit> hits) const;

  private:
    struct Release {
        void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
        void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    };
    std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release> device;
    std::unique_ptr<std::remove_pointer_t<RTCScene>, Release> scene;
};

} // namespace nacre
