#pragma once
#include "albedo/ordinates.h"
#include <limits>

namespace nacre::albedo {

/// What a half-space or a slab returns in the mean of light inside it: the share of its weight that leaves through the
/// side from which depths are counted, by the modes of the medium. As a flight's importance runs against the light,
/// those are the modes of the medium lit evenly on that side.
class Returned {
  public:
    /// 0 < albedo <= 1 - 1e-9, thickness in mean free paths. `ordinates`: of the medium with anisotropy g.
    Returned(const Ordinates &ordinates, double g, double albedo,
             double thickness = std::numeric_limits<double>::infinity());

    /// Legendre moments of the returned share by the cosine with which the light comes to a scatter, at a depth in mean
    /// free paths: what arrives with the cosine mu towards the side returns the sum of moment l times P_l(mu).
    Eigen::VectorXd moments(double depth) const;

    /// The share of light that enters through this side, and, of a slab, through the other one, with a density of 2 mu.
    double reflected() const { return back; }
    double transmitted() const { return through; }

  private:
    double thickness, back, through = 0;
    Eigen::VectorXd rate;
    Eigen::MatrixXd near, far; // moments x modes: of those that decay from this side, and from the other one
};

} // namespace nacre::albedo
