#include "device/exact.h"
#include "base/error.h"

namespace nacre::device {

std::string exact_options(const Device &device) {
    if (device.quirks.rounds_correctly) return "-DEXACT";
    const cl_device_fp_config found = device.info.device.getInfo<CL_DEVICE_SINGLE_FP_CONFIG>();
    constexpr cl_device_fp_config wanted = CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT | CL_FP_DENORM;
    if ((found & wanted) != wanted)
        throw Error(Exit::device, device.info.name,
                    "--exact needs a device that rounds quotients and square roots correctly and has denormal numbers; "
                    "this one does not promise it, leave the option out or take PoCL");
    return "-DEXACT -cl-fp32-correctly-rounded-divide-sqrt";
}

} // namespace nacre::device
