#include "albedo/ordinates.h"

namespace nacre::albedo {

Ordinates::Ordinates(double g, double bleed, shared::FlightLaw law, int cosines, double least_extinction)
    : phase(phase_nodes(g, cosines)), flight(flight_nodes(bleed, law, least_extinction)) {
    const Eigen::VectorXd &mu = phase.cosine.point, &share = phase.cosine.weight;
    const Eigen::Index size = cosines * extinctions();
    depth.resize(size);
    weight.resize(size);
    lambert.resize(size);
    uniform.resize(size);
    for (Eigen::Index k = 0; k < extinctions(); ++k) {
        depth.segment(k * cosines, cosines) = mu / flight.extinction[k];
        weight.segment(k * cosines, cosines) = share * flight.scatter[k];
        lambert.segment(k * cosines, cosines) = 2 * flight.first[k] * share.cwiseProduct(mu);
        uniform.segment(k * cosines, cosines) = share * flight.first[k];
    }
}

} // namespace nacre::albedo
