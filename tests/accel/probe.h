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

/// A ray that went on from where another one hit.
struct ProbeBounce {
    std::uint32_t first, second; // primitives, or BVH_NO_PRIMITIVE
    float t;                     // of the second
    float cosine;                // of its direction with the first's counter-clockwise normal
};

/// nacre's traversal on a device, on any rays one likes.
class RayProbe {
  public:
    /// The device's quirks say how (vector or scalar); the tree's width must be theirs. `stack`: entries of the
    /// traversal stack, 0: enough for the tree, rounded up so that trees share a program. `extra`: further compiler
    /// options.
    RayProbe(const device::Device &device, const accel::Bvh &bvh, const std::string &extra = {},
             std::uint32_t stack = 0);

    std::vector<ProbeHit> closest(std::uint32_t root, std::span<const ProbeRay> rays);
    std::vector<std::uint32_t> any(std::uint32_t root, std::span<const ProbeRay> rays); // 1: something is in the way
    /// Traces rays[i], and from where it hits directions[i].
    std::vector<ProbeBounce> bounce(std::uint32_t root, std::span<const ProbeRay> rays,
                                    std::span<const Vec3f> directions);

    /// In steps, for measuring: upload once, run (and wait) as often as needed; returns the device's seconds.
    void upload(std::uint32_t root, std::span<const ProbeRay> rays);
    double run_closest() { return run("probe_closest"); }
    std::vector<ProbeHit> hits() const;

  private:
    double run(const char *kernel);
    template <typename T> std::vector<T> read() const;

    device::Device device;
    cl::Program program;
    cl::Buffer nodes, blocks, rays, directions, results;
    std::uint32_t root = 0;
    std::size_t count = 0;
};

} // namespace nacre
