#include "oracle/adding_doubling.h"
#include <Eigen/Dense>
#include <cmath>
#include <numbers>

namespace nacre::test {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;
constexpr int nodes = 48;

/// Gauss-Legendre points and weights on (0, 1), by Newton's method on P_n.
void gauss(VectorXd &x, VectorXd &w) {
    x.resize(nodes);
    w.resize(nodes);
    for (int i = 0; i < nodes; ++i) {
        double z = std::cos(std::numbers::pi * (i + 0.75) / (nodes + 0.5)), slope = 0;
        for (int step = 0; step < 100; ++step) {
            double p0 = 1, p1 = z;
            for (int l = 2; l <= nodes; ++l) {
                const double p2 = ((2 * l - 1) * z * p1 - (l - 1) * p0) / l;
                p0 = p1;
                p1 = p2;
            }
            slope = nodes * (z * p1 - p0) / (z * z - 1);
            z -= p1 / slope;
        }
        x[i] = 0.5 * (1 + z);
        w[i] = 1 / ((1 - z * z) * slope * slope);
    }
}

/// Phase function averaged over azimuth, to the same side (+1) and the opposite side (-1), mean 1.
MatrixXd redistribution(const VectorXd &mu, double g, double side) {
    MatrixXd sum = MatrixXd::Zero(nodes, nodes);
    VectorXd p0 = VectorXd::Ones(nodes), p1 = mu;
    double moment = 1, sign = 1;
    for (int l = 0; l < 2 * nodes; ++l) {
        sum += (2 * l + 1) * moment * sign * p0 * p0.transpose();
        const VectorXd p2 = ((2 * l + 3) * mu.cwiseProduct(p1) - (l + 1) * p0) / (l + 2);
        p0 = p1;
        p1 = p2;
        moment *= g;
        sign *= side;
    }
    return sum;
}

} // namespace

double half_space_reflectance(double albedo, double g) {
    VectorXd mu, w;
    gauss(mu, w);
    const VectorXd flux = 2 * mu.cwiseProduct(w); // integrates a radiance to a flux
    const double thin = 1e-9;
    const VectorXd inverse = mu.cwiseInverse();
    // Operators act as (R I)(mu) = int R(mu, mu') I(mu') 2 mu' dmu': a matrix times diag(flux).
    MatrixXd r = albedo * thin / 4 * inverse.asDiagonal() * redistribution(mu, g, -1) * inverse.asDiagonal();
    MatrixXd t = albedo * thin / 4 * inverse.asDiagonal() * redistribution(mu, g, 1) * inverse.asDiagonal();
    t += VectorXd((-thin * inverse).array().exp() / flux.array()).asDiagonal();
    r = r * flux.asDiagonal();
    t = t * flux.asDiagonal();
    for (int doubling = 0; doubling < 60; ++doubling) { // 1e9 mean free paths
        const MatrixXd inside = (MatrixXd::Identity(nodes, nodes) - r * r).partialPivLu().solve(t);
        r += t * r * inside;
        t = t * inside;
    }
    return flux.dot(r * VectorXd::Ones(nodes)); // Lambertian light of flux 1 has radiance 1: int 2 mu dmu = 1
}

} // namespace nacre::test
