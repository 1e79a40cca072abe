#include "device/light_probe.h"
#include "device/program.h"
#include "render/upload.h"
#include "scene/features.h"
#include "scene/normalise.h"

namespace nacre::test {

scene::Scene scene_with_box() {
    scene::Scene scene;
    scene.materials.emplace_back();
    scene.objects.push_back({"box", scene::make_box({-1, -1, -1}, {1, 1, 1}), 0, 0});
    return scene;
}

std::vector<LightDraw> draw_lights(const scene::Scene &scene, const Vec3 &position, const Vec3 &normal,
                                   std::uint32_t count, std::uint32_t seed) {
    const device::Device device = device::open_device();
    device::Variant variant;
    variant.entry = "probe_light.cl";
    variant.features = scene::features(scene, false);
    const cl::Program program = device::build(device, variant).program;
    const render::DeviceScene uploaded = render::upload(device, scene, variant.features, {0, 0, 1, 1});
    const Vec3 p = scene::frame_of(scene).point(position);
    const cl_float4 at = {{float(p.x()), float(p.y()), float(p.z()), 0}};
    const cl_float4 up = {{float(normal.x()), float(normal.y()), float(normal.z()), 0}};

    const cl::Buffer out(device.context, CL_MEM_READ_WRITE, std::size_t(count) * 16 * sizeof(float));
    cl::Kernel kernel(program, "probe_light");
    const cl_uint first = uploaded.bind(kernel);
    kernel.setArg(first, at);
    kernel.setArg(first + 1, up);
    kernel.setArg(first + 2, seed);
    kernel.setArg(first + 3, count);
    kernel.setArg(first + 4, out);
    const std::size_t group = std::size_t(device.quirks.work_group);
    device.queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange((count + group - 1) / group * group),
                                      cl::NDRange(group));
    std::vector<float> v(std::size_t(count) * 16);
    device.queue.enqueueReadBuffer(out, true, 0, v.size() * sizeof(float), v.data());

    std::vector<LightDraw> draws(count);
    for (std::size_t i = 0; i < count; ++i) {
        const float *f = v.data() + 16 * i;
        draws[i] = {{f[0], f[1], f[2]},
                    f[3] * uploaded.length,
                    Vec3(f[4], f[5], f[6]) * uploaded.unit,
                    f[7],
                    {f[8], f[9]},
                    f[10],
                    Vec3(f[12], f[13], f[14]) * uploaded.unit};
    }
    return draws;
}

} // namespace nacre::test
