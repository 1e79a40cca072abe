#pragma once
#include "device/context.h"
#include <cstdint>

namespace nacre::bench {

/// A picture of a blob of skin in a white room.
struct Setting {
    double triangles = 1e5;       // of the blob, about
    double mean_free_path = 0.01; // of the red channel, in lengths of the blob's box
    int pixels = 256;             // a side
    std::uint32_t samples = 4;    // per pixel
};

/// Seconds of kernels per sample of a pixel, renderings by one session after a first that does not count: their median.
double seconds_per_sample(const device::Device &device, const Setting &setting, int runs);

} // namespace nacre::bench
