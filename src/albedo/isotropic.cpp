#include "albedo/isotropic.h"
#include <cmath>
#include <numbers>

namespace nacre::albedo {
namespace {

using Eigen::ArrayXd, Eigen::Index;

/// 1 - albedo K(k), where K is what is left after one flight and scatter of a wave exp(i k depth).
double dispersion(double albedo, double k, const FlightNodes &flight) {
    // 1 - atan(x) / x loses digits below .1: its series.
    const auto lost = [](double x) {
        const double x2 = x * x;
        if (x > 0.1) return 1 - std::atan(x) / x;
        return x2 * (1 / 3. - x2 * (1 / 5. - x2 * (1 / 7. - x2 * (1 / 9. - x2 * (1 / 11. - x2 / 13)))));
    };
    double sum = 1 - albedo;
    for (Index i = 0; i < flight.extinction.size(); ++i)
        sum += albedo * flight.scatter[i] * lost(k / flight.extinction[i]);
    return sum;
}

} // namespace

Reflectance reflectance_isotropic(double albedo, double bleed, shared::FlightLaw law) {
    const FlightNodes flight = flight_nodes(bleed, law, 0);
    // In u = ln k the integral's kernel is sech(u + ln z) / 2: the trapezoidal rule is exact to 1e-10 with this step.
    constexpr double step = 0.25;
    const GaussNodes cosine = gauss_nodes(32);
    const double nearest = std::log(cosine.point[0] * cosine.point[0] / flight.extinction.maxCoeff()),
                 farthest = std::log(1 / flight.extinction.minCoeff());
    const Index count = Index((farthest - nearest + 80) / step);
    const ArrayXd log_k = ArrayXd::LinSpaced(count, -farthest - 40, -farthest - 40 + step * double(count - 1));
    const ArrayXd log_loss =
        log_k.unaryExpr([&](double u) { return std::log(dispersion(albedo, std::exp(u), flight)); });

    Reflectance reflectance{1, 1};
    const double root = std::sqrt(1 - albedo);
    for (Index i = 0; i < cosine.point.size(); ++i) {
        // Cosines are squares of Gauss points: H has a logarithm at 0.
        const double mu = cosine.point[i] * cosine.point[i], share = 2 * cosine.point[i] * cosine.weight[i];
        for (Index j = 0; j < flight.extinction.size(); ++j) {
            const ArrayXd v = log_k + std::log(mu / flight.extinction[j]);
            const double log_h = -step / (2 * std::numbers::pi) * (log_loss / v.cosh()).sum();
            const double absorbed = share * flight.first[j] * root * std::exp(log_h);
            reflectance.lambert -= 2 * mu * absorbed;
            reflectance.uniform -= absorbed;
        }
    }
    return reflectance;
}

} // namespace nacre::albedo
