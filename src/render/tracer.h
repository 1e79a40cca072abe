#pragma once
#include "device/program.h"
#include "device/recorder.h"
#include "render/film.h"
#include "render/statistics.h"
#include "render/upload.h"
#include "shared/path.h"

namespace nacre::render {

/// The kernels of render.cl on one scene: traces batches and adds them to the device's film.
class Tracer {
  public:
    /// `film_pixels`: most pixels of the film, or of a list of tiles in a program of `variant.tile_list`. `capacity`:
    /// most paths of a batch.
    Tracer(const device::Device &device, const device::Program &program, const device::Variant &variant,
           const DeviceScene &scene, const Layers &layers, std::uint32_t film_pixels, std::uint32_t capacity,
           device::Recorder &recorder);

    /// To be called where the scene's buffers have changed. Returns the number of its arguments.
    cl_uint bind(const DeviceScene &scene);

    /// What batches and the film count the pixels of from here on: shared/path.h. Only of a program with lists.
    void list_tiles(const std::vector<shared::uint> &tiles);

    /// Traces a batch to its end (suspended paths included) and adds it to the film. Throws cl::Error; after one that
    /// says "out of resources" the batch may be tried again in smaller parts. Returns the seconds of its kernels.
    double trace(shared::Batch batch);

    /// The sums of the film's first `pixels` since the last call, and clears the film.
    std::vector<shared::float4> take_film(std::uint32_t pixels);

    /// Adds what was counted since the last call.
    void take_counters(Statistics &statistics);

    /// Bytes of the buffers that are not the scene's.
    std::vector<std::pair<std::string, std::size_t>> memory() const;

  private:
    const device::Device &device;
    device::Recorder &recorder;
    cl::Kernel trace_kernel, accumulate_kernel;
    cl_uint scene_arguments;
    std::uint32_t workers; // work-items of a launch that take paths as they can; 0: one path each
    std::uint32_t suspended_capacity;
    std::uint32_t planes; // float4 of a pixel of the film
    std::size_t layer_bytes = 0, film_bytes = 0, radiance_bytes = 0, path_bytes = 0, pool_bytes = 0, list_bytes = 0;
    cl::Buffer radiance, layers, film, counters, pool, list;
    cl::Buffer paths[2];               // suspended, resumed; they take turns
    std::vector<shared::uint> counted; // the counters between launches

    void clear_film(std::size_t bytes);
};

} // namespace nacre::render
