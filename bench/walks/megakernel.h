#pragma once
#include "device/program.h"
#include "render/upload.h"
#include "walks/walk_scene.h"

namespace nacre::bench {

/// The renderer's own kernel, trace_paths, on paths that are about to walk: it resumes them as if an earlier launch had
/// suspended them. The one place of this benchmark that knows how the kernel is called.
class Megakernel {
  public:
    /// Uploads and compiles. Throws Error{Exit::device}.
    Megakernel(device::Device device, const scene::Scene &scene);

    void upload(std::span<const shared::Path> paths);

    /// Follows the uploaded paths to their end and waits for it.
    void run();

    /// Of the last run, per slot.
    std::vector<shared::float4> radiance() const;
    /// Flights of its walks.
    std::uint64_t steps() const;

  private:
    const device::Device device;
    const render::DeviceScene scene;
    cl::Kernel kernel;
    cl_uint arguments;   // of the scene
    std::size_t workers; // 0: a work-item per path
    cl::Buffer paths, results, suspended, pool, counters;
    std::size_t count = 0;
};

} // namespace nacre::bench
