#include "accel/clearance_probe.h"
#include "device/program.h"

namespace nacre {
namespace {

template <typename T> cl::Buffer upload(const device::Device &device, const std::vector<T> &list) {
    cl::Buffer buffer(device.context, CL_MEM_READ_ONLY, list.size() * sizeof(T));
    device.queue.enqueueWriteBuffer(buffer, CL_TRUE, 0, list.size() * sizeof(T), list.data());
    return buffer;
}

} // namespace

std::vector<float> look_up(const device::Device &device, std::span<accel::ClearanceField> fields,
                           std::span<const ClearancePoint> points, int lanes) {
    device::Variant variant;
    variant.entry = "probe_clearance.cl";
    variant.lanes = lanes;
    cl::Kernel kernel(device::build(device, variant).program, "probe_clearance");

    std::vector<shared::Clearance> infos;
    std::vector<std::uint8_t> bricks;
    for (accel::ClearanceField &field : fields) {
        field.info.first = std::uint32_t(bricks.size());
        infos.push_back(field.info);
        bricks.insert(bricks.end(), field.bricks.begin(), field.bricks.end());
    }
    if (bricks.empty()) bricks.resize(CLEARANCE_BRICK_BYTES, 255);
    std::vector<ClearancePoint> all(points.begin(), points.end());
    all.resize((points.size() + std::size_t(lanes) - 1) / std::size_t(lanes) * std::size_t(lanes));
    static_assert(sizeof(ClearancePoint) == sizeof(shared::float4));

    const cl::Buffer out(device.context, CL_MEM_WRITE_ONLY, all.size() * sizeof(float));
    const cl::Buffer in = upload(device, all), about = upload(device, infos), codes = upload(device, bricks);
    kernel.setArg(0, in);
    kernel.setArg(1, about);
    kernel.setArg(2, codes);
    kernel.setArg(3, out);
    kernel.setArg(4, cl_uint(all.size()));
    const std::size_t local = std::size_t(device.quirks.work_group), items = all.size() / std::size_t(lanes);
    device.queue.enqueueNDRangeKernel(kernel, cl::NullRange, (items + local - 1) / local * local, local);
    std::vector<float> bounds(all.size());
    device.queue.enqueueReadBuffer(out, CL_TRUE, 0, bounds.size() * sizeof(float), bounds.data());
    bounds.resize(points.size());
    return bounds;
}

} // namespace nacre
