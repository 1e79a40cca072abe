#pragma once
#include "shared/guide.h"
#include <vector>

namespace nacre::guide {

/// The slowest decaying mode of light deep in a medium with a Henyey-Greenstein phase function, psi = phi(mu)
/// exp(-depth / nu) with mu the cosine towards the surface and lengths in mean free paths: the discrete eigenfunction
/// of Case & Zweifel 1967, "Linear Transport Theory", by its Legendre moments.
struct Eigenmode {
    double albedo, anisotropy;
    double nu;                   // > 1
    std::vector<double> moments; // of phi: the integral of phi P_l over mu, moments[0] = 1

    /// phi by its own equation, phi(mu) = albedo nu / (nu - mu) times the mean of phi over the phase function. mu in
    /// [-1, 1].
    double phi(double mu) const;
};

/// albedo in (0, 1), |anisotropy| < 1. nu is exact to about 1e-12 where nu > 1 + 1e-4.
Eigenmode eigenmode(double albedo, double anisotropy);

/// The mode of a medium as the kernels use it. Where GUIDE_TERMS Legendre polynomials do not hold phi (dark media,
/// whose phi is a needle) it is that of a brighter medium: a guide may be wrong, its estimator is exact with any.
/// `isotropic`: nu of the medium with that albedo and g = 0, as Krivanek & d'Eon 2014 have it.
shared::GuideMode guide_mode(double albedo, double anisotropy, bool isotropic);

} // namespace nacre::guide
