#pragma once
#include "device/program.h"
#include "device/recorder.h"
#include "render/upload.h"

namespace nacre::render {

/// Measures with the kernels of `program` how thick objects are and which of their sides are lit, and tells the scene;
/// until then walks take objects for half-spaces with the same light everywhere. Plates get slabs for their twins.
/// Where the camera sees no light on anything else, so that no walk has a use for its control variate, samples share
/// camera rays as without one. Returns whether the scene has other buffers than before.
bool measure(const device::Device &device, const device::Program &program, const scene::Scene &source,
             DeviceScene &scene, device::Recorder &recorder);

} // namespace nacre::render
