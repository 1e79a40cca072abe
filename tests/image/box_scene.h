#pragma once
#include "image/rendered.h"

namespace nacre {

/// What a box is made of: the single-scattering albedo of each channel, g, bleed, and the laws.
struct Medium {
    std::array<double, 3> albedo{1, 1, 1};
    double g = 0, bleed = 0;
    const char *entry = "lambert", *flight = "renewal";
};

/// A box whose face is a half-space to the camera, which looks straight at it: `thickness` mean free paths deep and as
/// many wide, in a white sky. A speck behind the camera puts the face at the scene's centre, where coordinates are
/// small and their rounding is much less than a mean free path.
scene::Scene half_space(const Medium &medium, double thickness);

/// The built-in box, of two triangles a side, `thickness` mean free paths deep and wide: walks start on large
/// triangles.
scene::Scene plain_box(const Medium &medium, double thickness);

/// A slab of optical depth `tau`, so wide that its edges are out of reach. With `plate` a black plate lies behind it,
/// which keeps the light off its back: the picture is then its reflectance alone, without it reflectance and
/// transmittance.
scene::Scene slab(const Medium &medium, double tau, bool plate);

/// A ball of optical radius `tau`, seen from the front.
scene::Scene ball(const Medium &medium, double tau);

} // namespace nacre
