#include "device/quirks.h"
#include "device/context.h"

namespace nacre::device {
namespace {

/// Width of the host's float vectors: a CPU device runs on the host's own cores.
int host_vector_width() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512vl")) return 16;
    if (__builtin_cpu_supports("avx2")) return 8;
#endif
    return 4;
}

struct Row {
    const char *name; // part of the platform's name or the device's
    Quirks quirks;
    const char *reason;
};

Quirks quirks_of_platform(const DeviceInfo &info) {
    const int width = host_vector_width();
    const Row rows[] = {
        {"Portable Computing Language",
         {.bvh_width = width, .bvh_vector = true, .lanes = width, .work_group = 1, .binary_cache = false},
         "PoCL does not vectorise divergent kernels: vectors are explicit, a work-group of one saves its loop. It "
         "caches machine code itself, in our private folder, and aborts on a binary it cannot read."},
        {"Oclgrind",
         {.bvh_width = 8,
          .bvh_vector = true,
          .lanes = 1,
          .work_group = 1,
          .binary_cache = false,
          .rounds_correctly = true},
         "False alarms on 16 wide vectors; has no binaries. It divides and takes roots in double, which rounded to "
         "float are "
         "right."},
        {"llvmpipe",
         {.bvh_width = 4, .bvh_vector = false, .lanes = 1, .work_group = 8, .binary_cache = true, .steps = 32},
         "Mesa's rusticl on the CPU (its other devices are GPUs like any): fastest with scalar code and groups of 8. A "
         "work-item leaves its loops, without a word, after 65535 iterations of all of them together "
         "(LP_MAX_TGSI_LOOP_ITERATIONS), of which a ray takes several hundred."},
        {"Intel(R) OpenCL",
         {.bvh_width = width, .bvh_vector = true, .lanes = width, .work_group = 1, .binary_cache = true},
         "A CPU runtime: explicit vectors as on PoCL."},
    };
    for (const Row &row : rows)
        if ((info.platform + '\n' + info.name).find(row.name) != std::string::npos) return row.quirks;
    if (info.type & CL_DEVICE_TYPE_CPU)
        return {.bvh_width = width, .bvh_vector = true, .lanes = width, .work_group = 1, .binary_cache = true};
    return {.bvh_width = 4, .bvh_vector = false, .lanes = 1, .work_group = 64, .binary_cache = true};
}

} // namespace

Quirks quirks_of(const DeviceInfo &info) {
    Quirks quirks = quirks_of_platform(info);
    // NVIDIA's compiler then writes into the build log how many registers a kernel takes and what it spills.
    if (info.device.getInfo<CL_DEVICE_EXTENSIONS>().find("cl_nv_compiler_options") != std::string::npos)
        quirks.options = "-cl-nv-verbose";
    return quirks;
}

} // namespace nacre::device
