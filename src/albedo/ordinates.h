#pragma once
#include "albedo/flight_nodes.h"
#include "albedo/phase_nodes.h"

namespace nacre::albedo {

/// Diffuse reflectance of a half-space, the share of the light that leaves it again, for both ways to enter it.
struct Reflectance {
    double lambert; // directions with a density of 2 mu
    double uniform; // over the hemisphere
};

/// The states of a flight in a half-space: cosine to the normal and extinction q, on nodes. Index: q's times the number
/// of cosines, plus the cosine's.
struct Ordinates {
    Ordinates(double g, double bleed, shared::FlightLaw law, int cosines, double least_extinction);

    Eigen::Index cosines() const { return phase.cosine.point.size(); }
    Eigen::Index extinctions() const { return flight.extinction.size(); }
    Eigen::Index size() const { return depth.size(); }

    PhaseNodes phase;
    FlightNodes flight;
    Eigen::VectorXd depth;            // mean depth of a flight, mu / q, in mean free paths
    Eigen::VectorXd weight;           // of flights from scatters, sum 1
    Eigen::VectorXd lambert, uniform; // of flights from the surface, sum 1
};

/// By the modes of the medium, all at once: discrete ordinates (Chandrasekhar 1960, "Radiative Transfer") with mu / q
/// for the cosine, split into even and odd parts. Decay rates come as singular values, so that small ones are as exact
/// as large ones, to 1e-13: flights of up to 1e9 mean free paths. 0 <= albedo <= 1 - 1e-9.
Reflectance reflectance_by_modes(const Ordinates &ordinates, double albedo);

/// By invariant imbedding (Ambartsumian 1943, Bellman et al. 1960): a layer more on a half-space does not change what
/// it reflects. Only sums of positive numbers, so that flights may have any length, but slow to converge for albedos
/// near
/// 1. Starts at, and leaves in `moments`, what r does to the phase function (size() x cosines(); empty: nothing).
Reflectance reflectance_by_imbedding(const Ordinates &ordinates, double albedo, Eigen::MatrixXd &moments);

} // namespace nacre::albedo
