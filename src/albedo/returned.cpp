#include "albedo/returned.h"
#include "albedo/modes.h"
#include "base/legendre.h"
#include <Eigen/Dense>
#include <cmath>

// The importance of flights outwards, u-, and inwards, u+, obeys the equations of the collision densities (modes.cpp)
// inwards and outwards: v du-/dz + u- = (albedo / 2) sum w (p_same u- + p_opposite u+), where at the surface u- is one.
// At a slab's other side, where the same modes begin with in- and outwards exchanged, u+ is none. A scatter of light
// with cosine mu returns half the sum of w p(mu, mu') u over the states after it.
namespace nacre::albedo {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

Returned::Returned(const Ordinates &ordinates, double g, double albedo, double thickness) : thickness(thickness) {
    const Modes modes = modes_of(ordinates, albedo);
    rate = modes.rate;
    const VectorXd root = ordinates.weight.cwiseSqrt();
    // sqrt(w) u- is half the sum of even and odd parts, sqrt(w) u+ half their difference.
    const MatrixXd outwards = 0.5 * (modes.even + modes.odd), inwards = 0.5 * (modes.even - modes.odd);
    const Eigen::PartialPivLU<MatrixXd> surface(outwards);
    VectorXd strength = surface.solve(root);
    VectorXd other = VectorXd::Zero(rate.size()); // of the modes that decay from the other side
    VectorXd here = inwards * strength;           // u+ on this side
    if (std::isfinite(thickness)) {
        const VectorXd across = (-thickness * rate).array().exp();
        const MatrixXd meets = surface.solve(inwards) * across.asDiagonal();
        strength = (MatrixXd::Identity(rate.size(), rate.size()) - meets * meets).partialPivLu().solve(strength);
        other = -meets * strength;
        here = inwards * strength + outwards * across.cwiseProduct(other);
        const VectorXd there = outwards * across.cwiseProduct(strength) + inwards * other; // u- on the other one
        through = ordinates.lambert.dot(there.cwiseQuotient(root));
    }
    back = ordinates.lambert.dot(here.cwiseQuotient(root));
    const Index n = ordinates.cosines(), count = 2 * n; // moments that n cosines hold
    MatrixXd polynomials(ordinates.size(), count);
    for (Index i = 0; i < ordinates.size(); ++i)
        polynomials.row(i) = legendre(ordinates.phase.cosine.point[i % n], count);
    polynomials = (0.5 * root).asDiagonal() * polynomials;
    near.resize(count, ordinates.size());
    far.resize(count, ordinates.size());
    for (Index l = 0; l < count; ++l) {
        const double sign = l % 2 == 0 ? 1 : -1, spread = double(2 * l + 1) * std::pow(g, double(l));
        near.row(l) = spread * (polynomials.col(l).transpose() * (outwards + sign * inwards));
        far.row(l) = sign * near.row(l);
    }
    near *= strength.asDiagonal();
    far *= other.asDiagonal();
}

VectorXd Returned::moments(double depth) const {
    VectorXd found = near * (-depth * rate).array().exp().matrix();
    if (std::isfinite(thickness)) found += far * (-(thickness - depth) * rate).array().exp().matrix();
    return found;
}

} // namespace nacre::albedo
