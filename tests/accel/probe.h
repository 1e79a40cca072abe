#pragma once
#include "accel/bvh.h"
#include "device/context.h"
#include <span>

namespace nacre {

/// A ray as kernels/probe_rays.cl reads it.
struct ProbeRay {
    Vec3f origin;
    float t_max = 1e30f;
    Vec3f direction;
    float t_min = 0;
};

/// What it writes: primitive is BVH_NO_PRIMITIVE for a miss.
struct ProbeHit {
    float t;
    std::uint32_t primitive, block, slot;
    bool hit() const { return primitive != BVH_NO_PRIMITIVE; }
};

/// nacre's traversal of a tree on a device, on any rays one likes.
class RayProbe {
  public:
    /// The device's quirks say how (vector or scalar); the tree's width must be theirs. `extra`: further compiler
    /// options.
    RayProbe(const device::Device &device, const accel::Bvh &bvh, std::uint32_t root, const std::string &extra = {});

    std::vector<ProbeHit> closest(std::span<const ProbeRay> rays);
    std::vector<std::uint32_t> any(std::span<const ProbeRay> rays); // 1: something is in the way

    /// In steps, for measuring: upload once, run (and wait) as often as needed.
    void upload(std::span<const ProbeRay> rays);
    void run_closest() { run("probe_closest"); }
    std::vector<ProbeHit> hits() const;

  private:
    void run(const char *kernel);
    template <typename T> std::vector<T> read() const;

    device::Device device;
    cl::Program program;
    cl::Buffer nodes, blocks, rays, results;
    std::uint32_t root = 0;
    std::size_t count = 0;
};

} // namespace nacre
