#pragma once
#include "device/program.h"
#include "device/recorder.h"
#include "render/upload.h"
#include "shared/guide.h"

namespace nacre::render {

/// Whether some sides of objects may have more light than others: not under nothing but environments of constant
/// radiance.
bool has_sides(const scene::Scene &scene);

/// Whether walks ask how thick an object is and where its light comes from: those with a guide or a control variate.
bool is_measured(const shared::Object &object);

/// Points on the surfaces of the objects that are measured, spread by area: for each position (w: its object) and unit
/// normal. Empty where all sides have the same light.
std::vector<shared::float4> light_points(const scene::Scene &scene, const Geometry &geometry);

/// The same light on all sides.
constexpr shared::LightSides all_alike{{1, 1, 1, 0}, {1, 1, 1, 0}, 0, 0, 1, 0};

/// Light on the other side over that on the side of a surface with this normal (guide/load.h, guide_far_light).
double far_light(const shared::LightSides &sides, const Vec3 &normal);

/// Measures the light on the scene's light_points, of which there are some, with the kernel of `program`. Of each
/// object.
std::vector<shared::LightSides> measure_light(const device::Device &device, const device::Program &program,
                                              const DeviceScene &scene, device::Recorder &recorder);

} // namespace nacre::render
