#pragma once
#include "accel/probe.h"
#include <ostream>

namespace nacre {

/// One way to traverse: width of the tree, vectors or a loop.
struct Mode {
    int width;
    bool vector;
    device::Device open() const {
        device::Device device = device::open_device();
        device.quirks.bvh_width = width;
        device.quirks.bvh_vector = vector;
        return device;
    }
};

inline const Mode all_modes[] = {{16, true}, {8, true}, {4, true}, {8, false}, {4, false}};

inline std::ostream &operator<<(std::ostream &out, const Mode &mode) {
    return out << mode.width << (mode.vector ? " wide vectors" : " wide loop");
}
inline std::string mode_name(const Mode &mode) {
    return (mode.vector ? "Vector" : "Loop") + std::to_string(mode.width);
}

} // namespace nacre
