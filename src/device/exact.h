#pragma once
#include "device/context.h"

namespace nacre::device {

/// Compiler options of a program that gives the same bits on every device: kernels/exact/builtins.h. Throws
/// Error{Exit::device} where the device does not promise what these bits rest on: quotients and square roots rounded
/// correctly, and denormal numbers.
std::string exact_options(const Device &device);

} // namespace nacre::device
