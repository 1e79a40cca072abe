#pragma once
#include "device/program.h"
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace nacre::device {

/// What the compiler made of a kernel, as far as the driver tells.
struct KernelInfo {
    std::string name;
    std::uint64_t private_bytes = 0, local_bytes = 0; // per work-item, per work-group
    std::uint64_t work_group = 0;                     // preferred sizes of a work-group are multiples of this
    std::optional<int> registers, spill_bytes;        // per work-item; spills: stores and loads
};

/// Of all kernels of a program, by name. Throws cl::Error.
std::vector<KernelInfo> kernel_infos(const Device &device, const Program &program);

struct RegisterUse {
    int registers = 0, spill_bytes = 0;
};

/// What NVIDIA's compiler says in the build log with -cl-nv-verbose, by kernel.
std::map<std::string, RegisterUse> register_use(const std::string &build_log);

} // namespace nacre::device
