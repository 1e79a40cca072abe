#pragma once
#include <Eigen/Core>

namespace nacre::albedo {

/// Gauss-Legendre points and weights on (0, 1), ascending, weights of sum 1.
struct GaussNodes {
    Eigen::VectorXd point, weight;
};
GaussNodes gauss_nodes(int count);

/// Henyey-Greenstein's phase function averaged over azimuth (mean 1 over the sphere) between cosines of Gauss nodes.
struct PhaseNodes {
    GaussNodes cosine;
    Eigen::MatrixXd same, opposite; // scattering within a hemisphere and into the other
};

/// `count` cosines in a hemisphere, |g| < 1. Legendre moments from 2 count on are g^(2 count) of a scatter straight
/// ahead (delta-M: Wiscombe 1977), which keeps the peak of |g| near 1 and the sum over directions exact.
PhaseNodes phase_nodes(double g, int count);

} // namespace nacre::albedo
