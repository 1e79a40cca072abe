#pragma once
#include "render/session.h"
#include <array>

namespace nacre::patch {

/// The flat face of a half-space of this material (only what lies below it: no specular layer), which a camera looks at
/// straight on, in a white sky: its picture is the material's colour. The half-space is a box `depth` mean free paths
/// deep and twice as wide; its pixels are independent of one another.
scene::Scene patch_scene(const scene::Material &material, double depth, int pixels);

/// A mean over pixels and its standard error, per channel.
struct Color {
    std::array<double, 3> value{}, error{};
};

/// The mean colour of a picture of patch_scene.
Color mean_color(const io::Picture &picture);

/// Renders patches of the material, one seed after the other, until no channel's standard error is above `error`.
/// `report` is told after each the share of the samples that are needed, as far as it is known; what it throws comes
/// out. Throws as render::Session does.
Color measure(const device::Device &device, const scene::Material &material, double error,
              const std::function<void(double)> &report = {});

} // namespace nacre::patch
