#pragma once
#include "albedo/ordinates.h"

namespace nacre::albedo {

/// What a half-space returns in the mean of light that scatters at some depth below its surface: the share of its
/// weight that leaves, by the modes of the medium. As a flight's importance runs against the light, those are the
/// modes of the half-space lit evenly from all sides.
class Returned {
  public:
    /// 0 < albedo <= 1 - 1e-9. `ordinates`: of the medium with anisotropy g.
    Returned(const Ordinates &ordinates, double g, double albedo);

    /// Legendre moments of the returned share by the cosine with which the light comes to the scatter, at a depth in
    /// mean free paths: what arrives with the cosine mu towards the surface returns the sum of moment l times P_l(mu).
    Eigen::VectorXd moments(double depth) const { return factors * (-depth * rate).array().exp().matrix(); }

  private:
    Eigen::VectorXd rate;
    Eigen::MatrixXd factors; // moments x modes
};

} // namespace nacre::albedo
