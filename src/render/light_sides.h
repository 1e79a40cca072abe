#pragma once
#include "device/program.h"
#include "device/recorder.h"
#include "render/upload.h"

namespace nacre::render {

/// Whether some sides of objects may have more light than others: not under nothing but environments of constant
/// radiance.
bool has_sides(const scene::Scene &scene);

/// Whether walks ask how thick an object is and where its light comes from: those with a guide or a control variate.
bool is_measured(const shared::Object &object);

/// Points on the surfaces of the objects that are measured, spread by area: for each position (w: its object) and unit
/// normal. Empty where all sides have the same light.
std::vector<shared::float4> light_points(const scene::Scene &scene, const Geometry &geometry);

/// Measures the light on these points with the kernel of `program` and tells the scene's walks which sides of its
/// objects have more. Until then they take all for equal. Where nothing that faces the camera is lit, so that no
/// walk has a use for its control variate, samples share camera rays as without one.
void measure_light_sides(const device::Device &device, const device::Program &program, const DeviceScene &scene,
                         device::Recorder &recorder);

} // namespace nacre::render
