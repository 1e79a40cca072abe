#pragma once
#include "device/opencl.h"
#include "device/quirks.h"
#include <filesystem>
#include <string>
#include <vector>

namespace nacre::device {

struct DeviceInfo {
    cl::Device device;
    int index = 0; // in list_devices()
    std::string platform, name, version, driver;
    cl_device_type type = 0;
    std::uint64_t memory = 0;
    std::uint32_t compute_units = 0;
};

/// All devices of all platforms that have any, in a fixed order. Never throws for a platform without devices.
std::vector<DeviceInfo> list_devices();

/// An opened device: its context, one in-order profiling queue, and what must be done differently on it.
struct Device {
    DeviceInfo info;
    Quirks quirks;
    cl::Context context;
    cl::CommandQueue queue;
    std::filesystem::path kernel_folder; // --kernels, empty: embedded
    std::filesystem::path dump_folder;   // --dump-kernel, empty: none; programs are then always compiled
};

/// Opens by index ("0"), type ("cpu", "gpu"), or part of the device's or platform's name; empty: NACRE_DEVICE, then a
/// GPU if there is one, then PoCL, then whatever there is. Throws Error{Exit::device} naming what exists.
Device open_device(const std::string &selector = {});

} // namespace nacre::device
