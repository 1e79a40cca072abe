#pragma once
#include "base/error.h"
#include "device/opencl.h"

namespace nacre::device {

/// "CL_OUT_OF_RESOURCES" for -5, and so on; the number itself where the name is not known.
std::string error_name(cl_int code);

/// An OpenCL failure as nacre reports it: the device, the call, the name of the error.
Error device_error(const std::string &device, const cl::Error &error);

/// The device lacks memory or time for a launch of this size; a smaller one may go through.
bool is_out_of_resources(const cl::Error &error);

} // namespace nacre::device
