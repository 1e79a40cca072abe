#pragma once
#include "patch/patch.h"

namespace nacre::patch {

struct Chart {
    io::Picture picture; // linear RGB, to be written as PNG
    double worst;        // largest difference of a channel's mean from the colour asked for, in codes of 8-bit sRGB
};

/// Patches of the material in the 24 colours of the ColorChecker, each beside the flat colour that was asked for:
/// what is left of a seam is the inversion's error. `report` is told the share that is done and may throw to stop.
Chart color_chart(const device::Device &device, const scene::Material &material, std::uint32_t spp,
                  const std::string &title, const std::function<void(double)> &report);

} // namespace nacre::patch
