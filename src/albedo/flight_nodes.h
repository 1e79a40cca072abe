#pragma once
#include "shared/scene.h"
#include <Eigen/Core>

namespace nacre::albedo {

/// Flights as a mixture of exponential ones. A Davis-Xu flight draws an extinction q with a Gamma law of mean 1, shape
/// a = 1 / bleed, and then flies exponentially with it (d'Eon 2018, "A Reciprocal Formulation of
/// Non-Exponential Radiative Transfer"): E[exp(-q tau)] = (1 + tau / a)^-a. In a plane medium q and the cosine mu only
/// occur as mu / q, so that every method for exponential flights holds with it in place of the cosine.
struct FlightNodes {
    Eigen::ArrayXd extinction;     // q, ascending, in units of the medium's
    Eigen::ArrayXd first, scatter; // weights, each of sum 1: of flights that start at the surface, and at a scatter
};

/// Nodes for bleed >= 0; exponential flights have one node. Extinctions below `least` are drawn as `least`: they fly
/// 1 / least mean free paths. Sums over functions like q / (q + x), x > 0, are within 1e-8 of the integral.
FlightNodes flight_nodes(double bleed, shared::FlightLaw law, double least);

} // namespace nacre::albedo
