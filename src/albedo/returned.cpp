#include "albedo/returned.h"
#include "albedo/modes.h"
#include "base/legendre.h"
#include <Eigen/Dense>
#include <cmath>

// The importance of flights outwards, u-, and inwards, u+, obeys the equations of the collision densities (modes.cpp)
// inwards and outwards: v du-/dz + u- = (albedo / 2) sum w (p_same u- + p_opposite u+), where at the surface u- is one.
// A scatter of light with cosine mu returns half the sum of w p(mu, mu') u over the states after it.
namespace nacre::albedo {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

Returned::Returned(const Ordinates &ordinates, double g, double albedo) {
    const Modes modes = modes_of(ordinates, albedo);
    rate = modes.rate;
    const VectorXd root = ordinates.weight.cwiseSqrt();
    // sqrt(w) u- is half the sum of even and odd parts, sqrt(w) u+ half their difference.
    const MatrixXd outwards = 0.5 * (modes.even + modes.odd), inwards = 0.5 * (modes.even - modes.odd);
    const VectorXd strength = outwards.partialPivLu().solve(root);
    const Index n = ordinates.cosines(), count = 2 * n; // moments that n cosines hold
    MatrixXd polynomials(ordinates.size(), count);
    for (Index i = 0; i < ordinates.size(); ++i)
        polynomials.row(i) = legendre(ordinates.phase.cosine.point[i % n], count);
    polynomials = (0.5 * root).asDiagonal() * polynomials;
    factors.resize(count, ordinates.size());
    for (Index l = 0; l < count; ++l) {
        const double sign = l % 2 == 0 ? 1 : -1, spread = double(2 * l + 1) * std::pow(g, double(l));
        factors.row(l) = spread * (polynomials.col(l).transpose() * (outwards + sign * inwards));
    }
    factors *= strength.asDiagonal();
}

} // namespace nacre::albedo
