#pragma once
#include "compare/estimate.h"
#include "compare/flip_color.h"
#include "compare/plane.h"
#include <numbers>

// FLIP: how different two pictures look to somebody who switches between them, 0 to 1 per pixel. Andersson, Nilsson,
// Akenine-Moller, Oskarsson, Astrom and Fairchild 2020, "FLIP: A Difference Evaluator for Alternating Images" (PACM
// CGIT 3:2); for renders: Andersson, Nilsson, Shirley and Akenine-Moller 2021, "Visualizing Errors in Rendered High
// Dynamic Range Images" (Eurographics short papers). No Debian package has it.
namespace nacre::compare {

/// The observer of the papers: a screen .7 m wide of 3840 pixels, .7 m away.
constexpr double pixels_per_degree = 0.7 * 3840 / 0.7 * std::numbers::pi / 180;

/// FLIP of two pictures as a screen shows them, in linear sRGB 0..1.
Plane ldr_flip(int width, int height, const std::vector<Color> &test, const std::vector<Color> &reference);

/// Exposures (stops) from that which shows the brightest pixel of the reference to that which shows its median well.
struct Exposures {
    double first = 0, last = 0;
    int count = 1;
    double at(int i) const { return count > 1 ? first + (last - first) * i / (count - 1) : first; }
};
Exposures exposures_of(const Estimate &reference);

/// The largest FLIP of every pixel over these exposures, tone-mapped (Narkowicz's fit of ACES): the picture's unit does
/// not matter. Numbers that are not finite count as 0, negative ones too.
Plane hdr_flip(const Estimate &test, const Estimate &reference);

} // namespace nacre::compare
