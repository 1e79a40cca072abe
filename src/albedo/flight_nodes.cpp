#include "albedo/flight_nodes.h"
#include <cmath>
#include <vector>

namespace nacre::albedo {

using Eigen::ArrayXd;

FlightNodes flight_nodes(double bleed, shared::FlightLaw law, double least) {
    if (bleed == 0) return {ArrayXd::Ones(1), ArrayXd::Ones(1), ArrayXd::Ones(1)};
    // The trapezoidal rule in ln q = sinh(k t) / k: its error falls exponentially with the step for functions of ln q
    // without poles near the axis, and sinh spares nodes in the long tail of small q, where weights are small. The step
    // follows the width of ln q's distribution, about 1 / sqrt(a) for large a.
    constexpr double k = 0.15, least_weight = 1e-12;
    const double a = 1 / bleed, step = 0.7 / std::sqrt(1 + 0.8 * a);
    const double norm = a * std::log(a) - std::lgamma(a);
    std::vector<double> extinction, weight;
    double lumped = 0;
    for (double t = std::ceil(-40 / step) * step; t < 40; t += step) {
        const double log_q = std::sinh(k * t) / k, q = std::exp(log_q);
        const double w = std::exp(norm + a * (log_q - q)) * std::cosh(k * t) * step; // Gamma density times q dt
        if (!(w > least_weight)) continue;
        if (q < least) {
            lumped += w;
            continue;
        }
        if (lumped > 0) {
            extinction.push_back(least);
            weight.push_back(lumped);
            lumped = 0;
        }
        extinction.push_back(q);
        weight.push_back(w);
    }
    FlightNodes nodes;
    nodes.extinction = Eigen::Map<ArrayXd>(extinction.data(), Eigen::Index(extinction.size()));
    nodes.first = Eigen::Map<ArrayXd>(weight.data(), Eigen::Index(weight.size()));
    nodes.first /= nodes.first.sum();
    // The Gamma law of shape a + 1, rate a, that reciprocal flights from scatters have, is q times that of shape a.
    nodes.scatter = law == shared::FLIGHT_RECIPROCAL ? ArrayXd(nodes.first * nodes.extinction) : nodes.first;
    nodes.scatter /= nodes.scatter.sum();
    return nodes;
}

} // namespace nacre::albedo
