#pragma once
#include "device/program.h"
#include "device/recorder.h"
#include "render/upload.h"

namespace nacre::render {

/// Finds out with the kernels of `program` how thick the measured objects are below each of their triangles, and tells
/// the scene. Until then they are half-spaces. Returns it by primitive, in the kernels' units.
std::vector<float> measure_thickness(const device::Device &device, const device::Program &program,
                                     const DeviceScene &scene, device::Recorder &recorder);

} // namespace nacre::render
