#include "compare/tail.h"
#include <cmath>
#include <limits>
#include <numbers>

namespace nacre::compare {

// P(|Z| >= z) = erfc(z / sqrt 2), so that P(Z >= sqrt 2) = erfc(1) / 2.
double sign_tail(double z) { return std::fmin(1, std::erfc(std::abs(z) / std::numbers::sqrt2) / (2 * std::erfc(1.0))); }

double sign_limit(double p) {
    double low = 0, high = 38; // where erfc is still a normal double
    if (sign_tail(high) > p) return std::numeric_limits<double>::infinity();
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (sign_tail(middle) > p ? low : high) = middle;
    }
    return high;
}

// expm1 and log1p: p may be far below a double's 1e-16.
double sidak(double p, double count) { return p < 1 ? -std::expm1(count * std::log1p(-p)) : 1; }

double sidak_level(double alpha, double count) { return -std::expm1(std::log1p(-alpha) / count); }

} // namespace nacre::compare
