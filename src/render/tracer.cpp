#include "render/tracer.h"
#include "shared/features.h"
#include <algorithm>

namespace nacre::render {
namespace {

using namespace shared;

/// How many of a batch's paths can be suspended at once. Workers keep no more than their pools. Elsewhere few paths
/// take so many steps, but all may where the device allows few; one that finds no room goes on.
std::uint32_t room_for_suspended(const device::Device &device, std::uint32_t workers, std::uint32_t features,
                                 std::uint32_t capacity) {
    if (workers > 0) return workers * POOL_PATHS;
    if (device.quirks.steps < device::Quirks{}.steps) return capacity;
    return features & FEATURE_SUBSURFACE ? capacity / 4 : 1;
}

cl::Buffer make(const device::Device &device, std::size_t bytes) {
    return bytes > 0 ? cl::Buffer(device.context, CL_MEM_READ_WRITE, bytes) : cl::Buffer();
}

} // namespace

Tracer::Tracer(const device::Device &device, const device::Program &program, const device::Variant &variant,
               const DeviceScene &scene, const Layers &kept, std::uint32_t film_pixels, std::uint32_t capacity,
               device::Recorder &recorder)
    : device(device), recorder(recorder), trace_kernel(program.program, "trace_paths"),
      accumulate_kernel(program.program, "accumulate"),
      workers(device.quirks.lanes > 1 ? device.info.compute_units : 0),
      suspended_capacity(room_for_suspended(device, workers, scene.frame.features, capacity)), planes(kept.planes()),
      counted(variant.profile ? PROFILE_WORDS : COUNTER_WORDS) {
    radiance_bytes = std::size_t(capacity) * sizeof(float4);
    layer_bytes = kept.kept() * radiance_bytes;
    film_bytes = std::size_t(film_pixels) * planes * sizeof(float4);
    list_bytes = variant.tile_list ? film_pixels / (TILE * TILE) * sizeof(uint) : 0;
    path_bytes = std::size_t(suspended_capacity) * sizeof(Path);
    pool_bytes = std::size_t(workers) * POOL_PATHS * sizeof(Path);
    radiance = make(device, radiance_bytes);
    layers = make(device, layer_bytes);
    film = make(device, film_bytes);
    counters = make(device, counted.size() * sizeof(uint));
    pool = make(device, pool_bytes);
    for (cl::Buffer &buffer : paths) buffer = make(device, path_bytes);
    list = make(device, list_bytes);
    clear_film(film_bytes);
    scene_arguments = bind(scene);
    trace_kernel.setArg(scene_arguments + 1, radiance);
    trace_kernel.setArg(scene_arguments + 2, layers);
    trace_kernel.setArg(scene_arguments + 5, counters);
    trace_kernel.setArg(scene_arguments + 6, pool);
    accumulate_kernel.setArg(scene_arguments + 1, radiance);
    accumulate_kernel.setArg(scene_arguments + 2, layers);
    accumulate_kernel.setArg(scene_arguments + 3, film);
    accumulate_kernel.setArg(scene_arguments + 4, planes);
    if (variant.tile_list) {
        trace_kernel.setArg(scene_arguments + 7, list);
        accumulate_kernel.setArg(scene_arguments + 5, list);
    }
}

cl_uint Tracer::bind(const DeviceScene &scene) {
    scene.bind(accumulate_kernel);
    return scene.bind(trace_kernel);
}

void Tracer::list_tiles(const std::vector<uint> &tiles) {
    device.queue.enqueueWriteBuffer(list, true, 0, tiles.size() * sizeof(uint), tiles.data(), nullptr,
                                    recorder.copy("list tiles"));
}

double Tracer::trace(Batch batch) {
    batch.resumed = 0;
    batch.capacity = suspended_capacity;
    batch.budget = std::uint32_t(device.quirks.steps);
    double seconds = 0;
    std::size_t items = std::size_t(batch.pixel_count) * batch.sample_count;
    const std::size_t counter_bytes = counted.size() * sizeof(uint);
    for (int turn = 0; items > 0; turn ^= 1) {
        counted[COUNTER_SUSPENDED] = counted[COUNTER_NEXT] = 0;
        device.queue.enqueueWriteBuffer(counters, false, 0, counter_bytes, counted.data(), nullptr,
                                        recorder.copy("write counters"));
        trace_kernel.setArg(scene_arguments, batch);
        trace_kernel.setArg(scene_arguments + 3, paths[turn]);
        trace_kernel.setArg(scene_arguments + 4, paths[turn ^ 1]);
        seconds += recorder.run(device, trace_kernel, workers > 0 ? workers : items);
        device.queue.enqueueReadBuffer(counters, true, 0, counter_bytes, counted.data(), nullptr,
                                       recorder.copy("read counters"));
        batch.resumed = std::min(counted[COUNTER_SUSPENDED], suspended_capacity);
        items = batch.resumed;
    }
    batch.resumed = 0;
    accumulate_kernel.setArg(scene_arguments, batch);
    return seconds + recorder.run(device, accumulate_kernel, batch.pixel_count);
}

std::vector<float4> Tracer::take_film(std::uint32_t pixels) {
    std::vector<float4> sums(std::size_t(pixels) * planes);
    const std::size_t bytes = sums.size() * sizeof(float4);
    device.queue.enqueueReadBuffer(film, true, 0, bytes, sums.data(), nullptr, recorder.copy("read film"));
    clear_film(bytes);
    return sums;
}

void Tracer::clear_film(std::size_t bytes) {
    // Like the counters, a whole buffer in one write: Oclgrind takes one that was filled, or written in part, for
    // uninitialised. (What a list does not use stays clear.)
    const std::vector<float4> black(bytes / sizeof(float4));
    device.queue.enqueueWriteBuffer(film, true, 0, bytes, black.data(), nullptr, recorder.copy("clear film"));
}

void Tracer::take_counters(Statistics &statistics) {
    if (counted.size() == PROFILE_WORDS) {
        statistics.profile.add(counted);
        std::fill(counted.begin() + PROFILE_TAIL, counted.end(), 0u);
    }
    for (int slice = 0; slice < COUNTER_SLICES; ++slice)
        for (int i = 0; i < COUNTER_COUNT; ++i) statistics.counters[i] += counted[slice * COUNTER_STRIDE + i];
    statistics.bad_sample = counted[COUNTER_BAD_SAMPLE];
    statistics.bad_step = counted[COUNTER_BAD_STEP];
    statistics.bad_pixel_x = counted[COUNTER_BAD_PIXEL];
    std::fill_n(counted.begin(), COUNTER_TAIL, 0u); // the first bad sample stays
}

std::vector<std::pair<std::string, std::size_t>> Tracer::memory() const {
    return {{"radiance", radiance_bytes}, {"layers", layer_bytes}, {"film", film_bytes},
            {"paths", 2 * path_bytes},    {"pool", pool_bytes},    {"tile list", list_bytes}};
}

} // namespace nacre::render
