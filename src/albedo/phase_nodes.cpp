#include "albedo/phase_nodes.h"
#include <cmath>
#include <numbers>

namespace nacre::albedo {

using Eigen::MatrixXd, Eigen::VectorXd;

GaussNodes gauss_nodes(int count) {
    GaussNodes nodes{VectorXd(count), VectorXd(count)};
    for (int i = 0; i < count; ++i) {
        double z = -std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5)), slope = 0;
        for (int step = 0; step < 100; ++step) { // Newton's method on P_count
            double p0 = 1, p1 = z;
            for (int l = 2; l <= count; ++l) {
                const double p2 = ((2 * l - 1) * z * p1 - (l - 1) * p0) / l;
                p0 = p1;
                p1 = p2;
            }
            slope = count * (z * p1 - p0) / (z * z - 1);
            z -= p1 / slope;
        }
        nodes.point[i] = 0.5 * (1 + z);
        nodes.weight[i] = 1 / ((1 - z * z) * slope * slope);
    }
    return nodes;
}

PhaseNodes phase_nodes(double g, int count) {
    PhaseNodes nodes{gauss_nodes(count), MatrixXd::Zero(count, count), MatrixXd::Zero(count, count)};
    const double ahead = std::pow(g, 2 * count);
    VectorXd p0 = VectorXd::Ones(count), p1 = nodes.cosine.point; // P_l, P_(l + 1)
    double moment = 1, sign = 1;
    for (int l = 0; l < 2 * count; ++l) {
        const MatrixXd term = (2 * l + 1) * (moment - ahead) * p0 * p0.transpose();
        nodes.same += term;
        nodes.opposite += sign * term;
        const VectorXd p2 = ((2 * l + 3) * nodes.cosine.point.cwiseProduct(p1) - (l + 1) * p0) / (l + 2);
        p0 = p1;
        p1 = p2;
        moment *= g;
        sign = -sign;
    }
    nodes.same.diagonal() += 2 * ahead * nodes.cosine.weight.cwiseInverse();
    return nodes;
}

} // namespace nacre::albedo
