#pragma once
#include "albedo/ordinates.h"

namespace nacre::albedo {

/// Reflectance of a half-space that scatters alike in all directions, to 1e-8: 1 - sqrt(1 - albedo) H(v), averaged over
/// the mean depths v of first flights (Chandrasekhar 1960), with H for any law of flights by
///     ln H(z) = -(1 / pi) int_0^inf ln(1 - albedo K(k)) z / (1 + z^2 k^2) dk,  K(k) = E[(q / k) atan(k / q)].
/// 0 <= albedo < 1, bleed >= 0.
Reflectance reflectance_isotropic(double albedo, double bleed, shared::FlightLaw law);

} // namespace nacre::albedo
