#include "device/kernel_info.h"
#include <algorithm>
#include <regex>
#include <sstream>

namespace nacre::device {

std::map<std::string, RegisterUse> register_use(const std::string &build_log) {
    static const std::regex entry("entry function '([^']+)'"), used("Used ([0-9]+) registers"),
        spilled("([0-9]+) bytes spill stores, ([0-9]+) bytes spill loads");
    std::map<std::string, RegisterUse> result;
    std::istringstream log(build_log);
    std::string kernel;
    std::smatch found;
    for (std::string line; std::getline(log, line);) {
        if (std::regex_search(line, found, entry)) kernel = found[1];
        if (kernel.empty()) continue;
        if (std::regex_search(line, found, used)) result[kernel].registers = std::stoi(found[1]);
        if (std::regex_search(line, found, spilled))
            result[kernel].spill_bytes = std::stoi(found[1]) + std::stoi(found[2]);
    }
    return result;
}

std::vector<KernelInfo> kernel_infos(const Device &device, const Program &program) {
    const auto use = register_use(program.log);
    std::vector<cl::Kernel> kernels;
    cl::Program(program.program).createKernels(&kernels);
    std::vector<KernelInfo> result;
    for (const cl::Kernel &kernel : kernels) {
        KernelInfo info;
        info.name = kernel.getInfo<CL_KERNEL_FUNCTION_NAME>();
        info.private_bytes = kernel.getWorkGroupInfo<CL_KERNEL_PRIVATE_MEM_SIZE>(device.info.device);
        info.local_bytes = kernel.getWorkGroupInfo<CL_KERNEL_LOCAL_MEM_SIZE>(device.info.device);
        info.work_group = kernel.getWorkGroupInfo<CL_KERNEL_PREFERRED_WORK_GROUP_SIZE_MULTIPLE>(device.info.device);
        if (const auto known = use.find(info.name); known != use.end()) {
            info.registers = known->second.registers;
            info.spill_bytes = known->second.spill_bytes;
        }
        result.push_back(info);
    }
    std::sort(result.begin(), result.end(), [](auto &a, auto &b) { return a.name < b.name; });
    return result;
}

} // namespace nacre::device
