#include "device/lane_probe.h"
#include "device/program.h"
#include "shared/features.h"
#include <map>

namespace nacre::test {
namespace {

using namespace shared;

constexpr std::uint32_t features = FEATURE_SUBSURFACE | FEATURE_BLEED | FEATURE_ANISOTROPY;

const device::Device &the_device() {
    static const device::Device device = device::open_device();
    return device;
}

cl::Kernel kernel(int lanes, const char *name) {
    static std::map<int, cl::Program> programs;
    const auto found = programs.find(lanes);
    if (found != programs.end()) return cl::Kernel(found->second, name);
    device::Variant variant;
    variant.entry = "probe_lanes.cl";
    variant.features = features;
    variant.lanes = lanes;
    return cl::Kernel(programs[lanes] = device::build(the_device(), variant).program, name);
}

std::vector<std::uint32_t> run(cl::Kernel kernel, int lanes, const std::vector<std::uint32_t> &in, std::size_t width) {
    const device::Device &device = the_device();
    const cl::Buffer from(device.context, CL_MEM_READ_ONLY, in.size() * 4);
    const cl::Buffer to(device.context, CL_MEM_WRITE_ONLY, width * in.size() * 4);
    device.queue.enqueueWriteBuffer(from, true, 0, in.size() * 4, in.data());
    kernel.setArg(0, from);
    kernel.setArg(1, to);
    device.queue.enqueueNDRangeKernel(kernel, cl::NullRange, in.size() / std::size_t(lanes),
                                      std::size_t(device.quirks.work_group));
    std::vector<std::uint32_t> out(width * in.size());
    device.queue.enqueueReadBuffer(to, true, 0, out.size() * 4, out.data());
    return out;
}

} // namespace

std::vector<std::uint32_t> run_function(int lanes, Function function, const std::vector<std::uint32_t> &in) {
    cl::Kernel probe = kernel(lanes, "probe_function");
    probe.setArg(2, cl_uint(function));
    return run(probe, lanes, in, 1);
}

std::vector<std::uint32_t> run_lane_hash(int lanes, const std::vector<std::uint32_t> &in) {
    return run(kernel(lanes, "probe_lane_hash"), lanes, in, 8);
}

std::vector<std::uint32_t> run_lane_walk(int lanes, const std::vector<std::uint32_t> &in, ChannelSampling sampling) {
    Frame frame{};
    frame.features = features;
    frame.channel_sampling = sampling;
    const cl::Buffer frames(the_device().context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, sizeof frame, &frame);
    cl::Kernel probe = kernel(lanes, "probe_lane_walk");
    probe.setArg(2, frames);
    return run(probe, lanes, in, 12);
}

} // namespace nacre::test
