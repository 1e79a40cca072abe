#pragma once
#include "device/context.h"
#include <string>

namespace nacre::device {

/// What a program is compiled for. Becomes -D options; equal variants share a cache entry.
struct Variant {
    std::string entry = "render.cl"; // file under kernels/
    std::uint32_t features = 0;      // mask of shared::Feature compiled in
    bool generic = false;            // everything compiled in, Frame.features decides at run time
    std::uint32_t bvh_stack = 64;    // entries of the traversal stack
    int lanes = 1;                   // walks side by side in one work-item
    bool profile = false;            // counts what shared/counters.h lists under PROFILE_LIST
    bool exact = false;              // the same bits on every device
    bool tile_list = false;          // pixels come from a list of tiles: -DTILE_LIST, shared/path.h
    std::string extra;               // further options, for probes and benches
};

/// Compiler options of a variant on a device. Always OpenCL C 1.2, never finite-math-only. Throws Error{Exit::device}
/// where the device cannot be exact.
std::string options(const Device &device, const Variant &variant);

struct Program {
    cl::Program program;
    std::string hash;   // of source, options, device and driver: the same text, the same program
    std::string log;    // what the compiler said, often nothing
    double seconds = 0; // to build or load
    bool cached = false;
};

/// Builds `variant`, or loads it from the binary cache. Throws Error{Exit::device} with the build log.
Program build(const Device &device, const Variant &variant);

} // namespace nacre::device
