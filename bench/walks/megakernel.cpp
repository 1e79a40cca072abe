#include "walks/megakernel.h"
#include "scene/features.h"
#include "shared/counters.h"

namespace nacre::bench {
namespace {

using namespace shared;

render::Crop whole_image(const scene::Scene &scene) {
    return {0, 0, std::uint32_t(scene.image.width), std::uint32_t(scene.image.height)};
}

} // namespace

Megakernel::Megakernel(device::Device opened, const scene::Scene &source)
    : device(std::move(opened)),
      scene(render::upload(device, source, scene::features(source, false), whole_image(source))),
      workers(device.quirks.lanes > 1 ? device.info.compute_units : 0),
      suspended(device.context, CL_MEM_READ_WRITE, sizeof(Path)),
      pool(device.context, CL_MEM_READ_WRITE, std::max<std::size_t>(1, workers * POOL_PATHS) * sizeof(Path)),
      counters(device.context, CL_MEM_READ_WRITE, COUNTER_WORDS * sizeof(uint)) {
    device::Variant variant;
    variant.features = scene.frame.features;
    variant.bvh_stack = scene.bvh_stack;
    variant.lanes = device.quirks.lanes;
    kernel = cl::Kernel(device::build(device, variant).program, "trace_paths");
    arguments = scene.bind(kernel);
    kernel.setArg(arguments + 2, cl::Buffer()); // layers: none
    kernel.setArg(arguments + 4, suspended);
    kernel.setArg(arguments + 5, counters);
    kernel.setArg(arguments + 6, pool);
}

void Megakernel::upload(std::span<const Path> list) {
    count = list.size();
    paths = cl::Buffer(device.context, CL_MEM_READ_ONLY, list.size_bytes());
    results = cl::Buffer(device.context, CL_MEM_READ_WRITE, count * sizeof(float4));
    device.queue.enqueueWriteBuffer(paths, CL_TRUE, 0, list.size_bytes(), list.data());
    Batch batch{};
    batch.resumed = uint(count);
    batch.budget = 0x7fffffff; // no path is suspended
    kernel.setArg(arguments, batch);
    kernel.setArg(arguments + 1, results);
    kernel.setArg(arguments + 3, paths);
}

void Megakernel::run() {
    const std::size_t group = std::size_t(device.quirks.work_group);
    const std::size_t items = workers > 0 ? workers : (count + group - 1) / group * group;
    device.queue.enqueueFillBuffer(counters, 0u, 0, COUNTER_WORDS * sizeof(uint));
    device.queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(items), cl::NDRange(group));
    device.queue.finish();
}

std::vector<float4> Megakernel::radiance() const {
    std::vector<float4> list(count);
    device.queue.enqueueReadBuffer(results, CL_TRUE, 0, count * sizeof(float4), list.data());
    return list;
}

std::uint64_t Megakernel::steps() const {
    std::vector<uint> words(COUNTER_WORDS);
    device.queue.enqueueReadBuffer(counters, CL_TRUE, 0, words.size() * sizeof(uint), words.data());
    std::uint64_t sum = 0;
    for (int slice = 0; slice < COUNTER_SLICES; slice++) sum += words[slice * COUNTER_STRIDE + COUNTER_steps];
    return sum;
}

} // namespace nacre::bench
