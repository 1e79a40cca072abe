#pragma once
#include "shared/scene.h"

namespace nacre::albedo {

/// A homogeneous medium but for its albedo, and how light enters it.
struct Medium {
    double anisotropy = 0, bleed = 0; // g in (-1, 1), bleed >= 0
    shared::FlightLaw flight = shared::FLIGHT_RENEWAL;
    shared::Entry entry = shared::ENTRY_LAMBERT;
};

/// Single-scattering albedo of a half-space that shows `color` under white light, as `inversion` has it; in [0, 1], 0
/// for 0 and 1 for 1 and above. Only `table` knows flights and entries; `chiang` is for g = 0, `memo` for g in [0,
/// .95]: others take the nearest.
double albedo(shared::Inversion inversion, double color, const Medium &medium);

} // namespace nacre::albedo
