#include "render/measure.h"
#include "device/buffer.h"
#include "render/light_sides.h"
#include "render/slabs.h"
#include "render/thickness.h"
#include <algorithm>

namespace nacre::render {
namespace {

using namespace shared;

template <typename T> void fill(const device::Device &device, DeviceScene::Entry &entry, const std::vector<T> &data) {
    entry.bytes = data.size() * sizeof(T);
    entry.buffer = device::constant_buffer(device, data.data(), entry.bytes);
}

/// Whether any walk may have a twin (kernels/path/control.h).
bool any_twins(const std::vector<LightSides> &light, const std::vector<Slab> &slabs) {
    constexpr float most_far_light = 1 / GUIDE_LEAST_LIGHT;
    return std::ranges::any_of(light, [](const LightSides &l) { return l.lit_in_sight != 0; }) ||
           std::ranges::any_of(slabs,
                               [](const Slab &s) { return s.through * most_far_light * CONTROL_MOST_LIGHT >= 1; });
}

} // namespace

bool measure(const device::Device &device, const device::Program &program, const scene::Scene &source,
             DeviceScene &scene, device::Recorder &recorder) {
    if (scene.measured.empty()) return false;
    const std::vector<float> thickness = measure_thickness(device, program, scene, recorder);
    std::vector<LightSides> light(source.objects.size(), all_alike);
    if (!scene.light_points.empty()) light = measure_light(device, program, scene, recorder);
    const Slabs found = choose_slabs(source, scene, thickness, light);
    const DeviceScene::Entry &sides = scene.entry("light_sides");
    device.queue.enqueueWriteBuffer(sides.buffer, true, 0, sides.bytes, light.data());
    const uint none = 0;
    if (scene.frame.lone_rays != 0 && !any_twins(light, found.slabs))
        device.queue.enqueueWriteBuffer(scene.entry("frame").buffer, true, offsetof(Frame, lone_rays), sizeof none,
                                        &none);
    if (found.slabs.empty()) return false;
    fill(device, scene.entry("slabs"), found.slabs);
    fill(device, scene.entry("transmitted"), found.transmitted);
    return true;
}

} // namespace nacre::render
