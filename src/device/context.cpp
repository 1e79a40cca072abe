#include "device/context.h"
#include "device/cache.h"
#include "device/error.h"
#include <algorithm>
#include <cstdlib>
#include <mutex>

namespace nacre::device {
namespace {

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return text;
}

std::string trimmed(std::string text) {
    text.erase(text.find_last_not_of(" \0\n", std::string::npos, 3) + 1);
    return text;
}

bool matches(const DeviceInfo &info, const std::string &selector) {
    if (selector == std::to_string(info.index)) return true;
    if (selector == "cpu") return info.type & CL_DEVICE_TYPE_CPU;
    if (selector == "gpu") return info.type & CL_DEVICE_TYPE_GPU;
    if (selector == "accelerator") return info.type & CL_DEVICE_TYPE_ACCELERATOR;
    return lower(info.name + "\n" + info.platform).find(selector) != std::string::npos;
}

/// A GPU if there is one, then PoCL, then the first device.
const DeviceInfo &best(const std::vector<DeviceInfo> &devices) {
    const auto gpu = std::find_if(devices.begin(), devices.end(), [](auto &d) { return d.type & CL_DEVICE_TYPE_GPU; });
    if (gpu != devices.end()) return *gpu;
    const auto pocl = std::find_if(devices.begin(), devices.end(), [](auto &d) {
        return d.platform.find("Portable Computing Language") != std::string::npos;
    });
    return pocl != devices.end() ? *pocl : devices.front();
}

const DeviceInfo &select(const std::vector<DeviceInfo> &devices, const std::string &selector) {
    if (selector.empty()) return best(devices);
    for (const DeviceInfo &info : devices)
        if (matches(info, lower(selector))) return info;
    std::string known;
    for (const DeviceInfo &info : devices) known += fmt::format(" {}: {};", info.index, info.name);
    throw Error(Exit::device, "--device " + selector,
                fmt::format("no such device; there is{} choose by index, cpu, gpu or part of a name", known));
}

} // namespace

std::vector<DeviceInfo> list_devices() {
    static std::once_flag once;
    std::call_once(once, prepare_pocl_cache);
    std::vector<DeviceInfo> devices;
    std::vector<cl::Platform> platforms;
    try {
        cl::Platform::get(&platforms);
    } catch (const cl::Error &) {
        return devices; // the loader reports "no platform" as an error
    }
    for (const cl::Platform &platform : platforms) {
        std::vector<cl::Device> found;
        try {
            platform.getDevices(CL_DEVICE_TYPE_ALL, &found);
        } catch (const cl::Error &) {
            continue; // a platform without devices (Clover without a GPU)
        }
        for (const cl::Device &device : found) {
            DeviceInfo info;
            info.device = device;
            info.index = int(devices.size());
            info.platform = trimmed(platform.getInfo<CL_PLATFORM_NAME>());
            info.name = trimmed(device.getInfo<CL_DEVICE_NAME>());
            info.version = trimmed(device.getInfo<CL_DEVICE_VERSION>());
            info.driver = trimmed(device.getInfo<CL_DRIVER_VERSION>());
            info.type = device.getInfo<CL_DEVICE_TYPE>();
            info.memory = device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>();
            info.compute_units = device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
            devices.push_back(std::move(info));
        }
    }
    return devices;
}

Device open_device(const std::string &selector) {
    const auto devices = list_devices();
    if (devices.empty())
        throw Error(Exit::device, "OpenCL",
                    "no device found; install one, for example PoCL: apt-get install pocl-opencl-icd");
    const char *environment = std::getenv("NACRE_DEVICE");
    Device result;
    result.info = select(devices, !selector.empty() ? selector : environment ? environment : "");
    result.quirks = quirks_of(result.info);
    for (const bool again : {false, true}) {
        try {
            result.context = cl::Context(result.info.device);
            result.queue = cl::CommandQueue(result.context, result.info.device, CL_QUEUE_PROFILING_ENABLE);
            break;
        } catch (const cl::Error &error) {
            if (again) throw device_error(result.info.name, error);
            wipe_pocl_cache(); // a broken cache keeps PoCL from making a context
        }
    }
    return result;
}

} // namespace nacre::device
