#pragma once
#include <string>

namespace nacre::device {

/// What a device needs done differently; the table with the reasons is quirks.cpp.
struct Quirks {
    int bvh_width = 8;        // children per BVH node: 16, 8 or 4
    bool bvh_vector = false;  // test a node's children in one vector operation, else in a loop
    int work_group = 64;      // the one work-group size of every kernel
    bool binary_cache = true; // keep program binaries of our own
    int steps = 4096;         // a path takes before it is suspended: some milliseconds, so that no launch hangs
};

struct DeviceInfo;
Quirks quirks_of(const DeviceInfo &info);

} // namespace nacre::device
