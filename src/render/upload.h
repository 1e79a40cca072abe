#pragma once
#include "base/timeline.h"
#include "device/context.h"
#include "render/geometry.h"
#include "render/lights.h"
#include "render/statistics.h"
#include "scene/scene.h"
#include <string>
#include <vector>

namespace nacre::render {

/// Part of the image that is rendered, in pixels: [x0, x1) x [y0, y1).
struct Crop {
    std::uint32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    std::uint32_t width() const { return x1 - x0; }
    std::uint32_t height() const { return y1 - y0; }
};

/// A scene on a device: one buffer for each argument of SCENE_PARAMETERS, in that order. What no feature asks for is
/// not made: its buffer is null.
struct DeviceScene {
    struct Entry {
        std::string name;
        cl::Buffer buffer;
        std::size_t bytes = 0;
    };
    std::vector<Entry> buffers;
    shared::Frame frame{};
    std::string hash;  // of everything uploaded: the same picture on the same device, if the kernels are the same
    double unit = 1;   // film -> radiance
    double length = 1; // kernels' lengths -> scene units
    std::uint32_t bvh_stack = 0;
    Startup startup;                          // what of it was spent here
    std::vector<shared::float4> light_points; // for measure_light_sides: positions and normals in turns
    /// Objects whose walks ask how thick they are and where their light comes from.
    struct Measured {
        shared::uint object;
        Blocks blocks;
        shared::uint first_primitive;
        bool plate;              // Object::plate
        float control_thickness; // likewise
    };
    std::vector<Measured> measured;
    std::vector<shared::Material> materials; // as they were uploaded

    const Entry &entry(std::string_view name) const;
    Entry &entry(std::string_view name) { return const_cast<Entry &>(std::as_const(*this).entry(name)); }

    /// Sets the scene's arguments of a kernel; returns the index of the next one.
    cl_uint bind(cl::Kernel &kernel) const;
};

DeviceScene upload(const device::Device &device, const scene::Scene &scene, std::uint32_t features, const Crop &crop,
                   Timeline *timeline = nullptr);

} // namespace nacre::render
