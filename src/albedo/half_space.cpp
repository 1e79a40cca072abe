#include "albedo/half_space.h"
#include "albedo/isotropic.h"
#include <cmath>
#include <numbers>

namespace nacre::albedo {
namespace {

constexpr int cosines = 12, fine_cosines = 64;
constexpr double least_extinction = 1e-9; // for modes
constexpr double least_imbedded = 0.1;    // similarity, below which imbedding takes long to converge

/// Rare long flights, beyond what modes hold, still matter.
bool long_flights(double bleed, shared::FlightLaw law) {
    const double tail = bleed == 0 ? 1e9 : 1 / bleed + (law == shared::FLIGHT_RECIPROCAL ? 1 : 0);
    return std::pow(least_extinction, tail) > 1e-8;
}

/// Reflectances of one medium for one albedo after the other, at best falling ones: each may start from the last.
class Solver {
  public:
    Solver(double g, double bleed, shared::FlightLaw law)
        : g(g), bleed(bleed), law(law), imbedded(long_flights(bleed, law)),
          medium(g, bleed, law, cosines, imbedded ? 0 : least_extinction), coarse(g, 0, law, cosines, 1),
          fine(g, 0, law, fine_cosines, 1) {}

    Reflectance operator()(double albedo) {
        if (albedo <= 0) return {0, 0};
        if (albedo >= 1) return {1, 1};
        if (g == 0) return reflectance_isotropic(albedo, bleed, law);
        const Reflectance exact = reflectance_by_modes(fine, albedo);
        if (bleed == 0) return exact;
        const Reflectance with = imbedded ? reflectance_by_imbedding(medium, albedo, moments)
                                          : reflectance_by_modes(medium, albedo),
                          without = reflectance_by_modes(coarse, albedo);
        // What few cosines get wrong is much the same with bleed and without.
        return {exact.lambert + (with.lambert - without.lambert), exact.uniform + (with.uniform - without.uniform)};
    }

  private:
    double g, bleed;
    shared::FlightLaw law;
    bool imbedded;
    Ordinates medium, coarse, fine;
    Eigen::MatrixXd moments;
};

} // namespace

double albedo_of(double similarity, double g) {
    const double s2 = similarity * similarity;
    return (1 - s2) / (1 - g * s2);
}

Reflectance reflectance(double albedo, double g, double bleed, shared::FlightLaw law) {
    return Solver(g, bleed, law)(albedo);
}

HalfSpace::HalfSpace(double g, double bleed, shared::FlightLaw law) {
    // Renewal flights: colour is analytic in the similarity, even at 0, with any bleed. Reciprocal ones: near 0 it is a
    // sum of broken powers, the least of them min(1, 2 / (1 + bleed)), which Chebyshev's points in a root of s bear.
    const bool reciprocal = law == shared::FLIGHT_RECIPROCAL && bleed > 0;
    power = reciprocal ? std::max(3.0, 1 + bleed) : 1;
    const int count = reciprocal ? 24 : 13;
    double least = long_flights(bleed, law) ? least_imbedded : 0.02;
    if (reciprocal) {
        // Modes hold for losses that rounding and the longest flight leave: walks go losses^(-1 / tail) mean free paths
        // deep. Nearer to white the first flight's tail is all that counts: 1 - color = c (1 - albedo)^(a / tail).
        const double tail = std::min(2.0, 1 + 1 / bleed), depth = 0.005 / least_extinction;
        least = std::pow(std::max(1e-10, std::pow(depth, -tail)) / (1 - g), 0.5 / power);
        white = bleed > 1 ? 2 * power / (1 + bleed) : power;
    } else {
        node.push_back(0);
    }
    for (int i = count - 1; i >= 0; --i) // Chebyshev's points
        node.push_back(least + (1 - least) * 0.5 * (1 + std::cos(std::numbers::pi * i / (count - 1))));
    Solver solver(g, bleed, law);
    known.resize(node.size());
    for (std::size_t i = node.size(); i-- > 0;) known[i] = solver(albedo_of(std::pow(node[i], power), g));
    for (const double at : node) {
        double product = 1;
        for (const double other : node)
            if (other != at) product *= 4 * (at - other);
        factor.push_back(1 / product);
    }
}

double HalfSpace::color(double similarity, shared::Entry entry) const {
    const auto value = [&](std::size_t i) {
        return entry == shared::ENTRY_UNIFORM ? known[i].uniform : known[i].lambert;
    };
    const double at = std::pow(similarity, 1 / power);
    if (at < node[0]) return 1 - (1 - value(0)) * std::pow(at / node[0], white);
    double sum = 0, weights = 0;
    for (std::size_t i = 0; i < node.size(); ++i) {
        if (at == node[i]) return value(i);
        const double w = factor[i] / (at - node[i]);
        sum += w * value(i);
        weights += w;
    }
    return sum / weights;
}

double HalfSpace::similarity(double color, shared::Entry entry) const {
    if (color <= 0) return 1;
    if (color >= 1) return 0;
    double low = 0, high = 1; // of the node
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (this->color(std::pow(middle, power), entry) > color ? low : high) = middle;
    }
    return std::pow((low + high) / 2, power);
}

} // namespace nacre::albedo
