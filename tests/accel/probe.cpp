#include "accel/probe.h"
#include "device/program.h"
#include <algorithm>
#include <fmt/format.h>

namespace nacre {
namespace {

constexpr std::size_t rays_per_item = 1024; // few work-items: PoCL spends time on each

cl::Buffer upload_floats(const device::Device &device, const std::vector<float> &data) {
    const std::size_t bytes = std::max<std::size_t>(data.size(), 1) * sizeof(float);
    cl::Buffer buffer(device.context, CL_MEM_READ_ONLY, bytes);
    if (!data.empty()) device.queue.enqueueWriteBuffer(buffer, CL_TRUE, 0, bytes, data.data());
    return buffer;
}

} // namespace

RayProbe::RayProbe(const device::Device &device, const accel::Bvh &bvh, std::uint32_t root, const std::string &extra)
    : device(device), nodes(upload_floats(device, bvh.nodes)), blocks(upload_floats(device, bvh.blocks)), root(root) {
    device::Variant variant;
    variant.entry = "probe_rays.cl";
    variant.bvh_stack = std::max(bvh.stack, 1u);
    variant.extra = fmt::format("-DRAYS_PER_ITEM={} {}", rays_per_item, extra);
    program = device::build(device, variant).program;
}

void RayProbe::upload(std::span<const ProbeRay> list) {
    static_assert(sizeof(ProbeRay) == 32 && sizeof(ProbeHit) == 16, "two float4, one uint4");
    count = list.size();
    rays = cl::Buffer(device.context, CL_MEM_READ_ONLY, list.size_bytes());
    results = cl::Buffer(device.context, CL_MEM_WRITE_ONLY, count * sizeof(ProbeHit));
    device.queue.enqueueWriteBuffer(rays, CL_TRUE, 0, list.size_bytes(), list.data());
}

void RayProbe::run(const char *name) {
    cl::Kernel kernel(program, name);
    kernel.setArg(0, rays);
    kernel.setArg(1, results);
    kernel.setArg(2, nodes);
    kernel.setArg(3, blocks);
    kernel.setArg(4, root);
    kernel.setArg(5, static_cast<cl_uint>(count));
    const std::size_t local = device.quirks.work_group, items = (count + rays_per_item - 1) / rays_per_item;
    device.queue.enqueueNDRangeKernel(kernel, cl::NullRange, (items + local - 1) / local * local, local);
    device.queue.finish();
}

template <typename T> std::vector<T> RayProbe::read() const {
    std::vector<T> out(count);
    device.queue.enqueueReadBuffer(results, CL_TRUE, 0, count * sizeof(T), out.data());
    return out;
}

std::vector<ProbeHit> RayProbe::hits() const { return read<ProbeHit>(); }

std::vector<ProbeHit> RayProbe::closest(std::span<const ProbeRay> list) {
    upload(list);
    run("probe_closest");
    return hits();
}

std::vector<std::uint32_t> RayProbe::any(std::span<const ProbeRay> list) {
    upload(list);
    run("probe_any");
    return read<std::uint32_t>();
}

} // namespace nacre
