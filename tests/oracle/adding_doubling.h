#pragma once

namespace nacre::test {

/// Diffuse reflectance of a half-space with exponential flights and Henyey-Greenstein scattering under Lambertian entry
/// (light with density 2 mu, all azimuths), in float64 and without random numbers: adding-doubling (van de Hulst 1980,
/// "Multiple Light Scattering", vol. 1) from a layer of 1e-9 mean free paths, on Gauss points in mu. albedo in [0,
/// .999], |g| <= .95: within 1e-6 of the H-function at g = 0.
double half_space_reflectance(double albedo, double g);

} // namespace nacre::test
