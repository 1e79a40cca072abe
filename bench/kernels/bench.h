#pragma once
#include "device/program.h"
#include <benchmark/benchmark.h>

namespace nacre::bench {

/// The device of all benchmarks: NACRE_DEVICE, or the default one; CPU devices on one thread.
const device::Device &the_device();

/// Runs `kernel` on `items` work-items, waits, and returns the seconds that the device took (OpenCL profiling).
double kernel_seconds(const cl::Kernel &kernel, std::size_t items);

/// Each file of this folder registers its benchmarks, main() calls them all. A new room is a new file, and a line here.
void register_lanes();
void register_clearance();
void register_traversal();

} // namespace nacre::bench
