#include "accel/probe.h"
#include "device/buffer.h"
#include "device/program.h"
#include <fmt/format.h>
#include <string_view>

namespace nacre {
namespace {

constexpr std::size_t rays_per_item = 1024; // few work-items: PoCL spends time on each

template <typename T> cl::Buffer upload_list(const device::Device &device, std::span<const T> list) {
    cl::Buffer buffer(device.context, CL_MEM_READ_ONLY, std::max<std::size_t>(list.size_bytes(), sizeof(T)));
    if (!list.empty()) device.queue.enqueueWriteBuffer(buffer, CL_TRUE, 0, list.size_bytes(), list.data());
    return buffer;
}

std::uint32_t rounded_up(std::uint32_t stack) { return std::max(stack + 63, 64u) / 64 * 64; }

} // namespace

RayProbe::RayProbe(const device::Device &device, const accel::Bvh &bvh, const std::string &extra, std::uint32_t stack)
    : device(device), nodes(device::constant_buffer<float>(device, bvh.nodes)),
      blocks(device::constant_buffer<float>(device, bvh.blocks)) {
    device::Variant variant;
    variant.entry = "probe_rays.cl";
    variant.lanes = device.quirks.lanes;
    variant.bvh_stack = stack ? stack : rounded_up(bvh.stack);
    variant.extra = fmt::format("-DRAYS_PER_ITEM={} {}", rays_per_item, extra);
    program = device::build(device, variant).program;
}

void RayProbe::upload(std::uint32_t tree, std::span<const ProbeRay> list) {
    static_assert(sizeof(ProbeRay) == 32 && sizeof(ProbeHit) == 16 && sizeof(ProbeBounce) == 16, "float4 and uint4");
    root = tree;
    count = list.size();
    rays = upload_list(device, list);
    results = cl::Buffer(device.context, CL_MEM_WRITE_ONLY, count * sizeof(ProbeHit));
}

double RayProbe::run(const char *name) {
    cl::Kernel kernel(program, name);
    kernel.setArg(0, rays);
    kernel.setArg(1, results);
    kernel.setArg(2, nodes);
    kernel.setArg(3, blocks);
    kernel.setArg(4, root);
    kernel.setArg(5, static_cast<cl_uint>(count));
    if (std::string_view(name) == "probe_bounce") kernel.setArg(6, directions);
    const std::size_t local = device.quirks.work_group, items = (count + rays_per_item - 1) / rays_per_item;
    cl::Event event;
    device.queue.enqueueNDRangeKernel(kernel, cl::NullRange, (items + local - 1) / local * local, local, nullptr,
                                      &event);
    event.wait();
    return 1e-9 * double(event.getProfilingInfo<CL_PROFILING_COMMAND_END>() -
                         event.getProfilingInfo<CL_PROFILING_COMMAND_START>());
}

template <typename T> std::vector<T> RayProbe::read() const {
    std::vector<T> out(count);
    device.queue.enqueueReadBuffer(results, CL_TRUE, 0, count * sizeof(T), out.data());
    return out;
}

std::vector<ProbeHit> RayProbe::hits() const { return read<ProbeHit>(); }

std::vector<ProbeHit> RayProbe::closest(std::uint32_t tree, std::span<const ProbeRay> list) {
    upload(tree, list);
    run("probe_closest");
    return hits();
}

std::vector<std::uint32_t> RayProbe::any(std::uint32_t tree, std::span<const ProbeRay> list) {
    upload(tree, list);
    run("probe_any");
    return read<std::uint32_t>();
}

std::vector<ProbeBounce> RayProbe::bounce(std::uint32_t tree, std::span<const ProbeRay> list,
                                          std::span<const Vec3f> onward) {
    upload(tree, list);
    directions = upload_list(device, onward);
    run("probe_bounce");
    return read<ProbeBounce>();
}

} // namespace nacre
