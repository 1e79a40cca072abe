#pragma once
#include <string>

namespace nacre::device {

/// What a device needs done differently; the table with the reasons is quirks.cpp.
struct Quirks {
    int bvh_width = 8;        // children per BVH node: 16, 8 or 4
    bool bvh_vector = false;  // test a node's children in one vector operation, else in a loop
    int lanes = 1;            // walks side by side in a work-item: 16, 8, 4, or 1 where work-items are lanes already
    int work_group = 64;      // the one work-group size of every kernel
    bool binary_cache = true; // keep program binaries of our own
    // Steps that a path, or a worker that finds no new one, may take before it is suspended: some milliseconds, so that
    // no launch hangs on a few endless walks.
    int steps = 4096;
    bool rounds_correctly = false; // quotients and square roots, though it does not say so
    std::string options = {};      // of its compiler alone
};

struct DeviceInfo;
Quirks quirks_of(const DeviceInfo &info);

} // namespace nacre::device
