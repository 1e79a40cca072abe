#pragma once
#include "device/program.h"
#include "device/recorder.h"

namespace nacre::render {

/// Compares the sizes of the shared structs with what the device says. Throws Error{Exit::device} when one differs.
void check_layout(const device::Device &device, const device::Program &program, device::Recorder &recorder);

} // namespace nacre::render
