#include "render/thickness.h"

namespace nacre::render {

using namespace shared;

std::vector<float> measure_thickness(const device::Device &device, const device::Program &program,
                                     const DeviceScene &scene, device::Recorder &recorder) {
    const DeviceScene::Entry &out = scene.entry("thickness");
    std::vector<float> thickness(out.bytes / sizeof(float), GUIDE_THICK);
    const cl::Buffer found(device.context, CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR, out.bytes, thickness.data());
    cl::Kernel kernel(program.program, "object_thickness");
    const cl_uint argument = scene.bind(kernel);
    for (const DeviceScene::Measured &object : scene.measured) {
        const uint slots = object.blocks.count * uint(device.quirks.bvh_width);
        kernel.setArg(argument, object.object);
        kernel.setArg(argument + 1, object.blocks.first);
        kernel.setArg(argument + 2, slots);
        kernel.setArg(argument + 3, found);
        recorder.run(device, kernel, slots);
    }
    device.queue.enqueueReadBuffer(found, true, 0, out.bytes, thickness.data());
    device.queue.enqueueWriteBuffer(out.buffer, true, 0, out.bytes, thickness.data());
    return thickness;
}

} // namespace nacre::render
