#include "guide/eigenmode.h"
#include "base/legendre.h"
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace nacre::guide {
namespace {

using namespace shared;

// Moments beyond this have no weight: g^l is below 1e-9, and the mode itself falls like (nu + sqrt(nu^2 - 1))^-l.
int moments_of(double g) {
    const double decay = g == 0 ? 0 : std::log(1e-9) / std::log(std::abs(g));
    return std::clamp(64 + int(decay), 96, 1000);
}

/// Factors of the Legendre polynomials with the least relative error in phi, at Chebyshev's points. Returns the
/// largest.
double fit(const Eigenmode &mode, Eigen::VectorXd &factors) {
    constexpr int points = 8 * GUIDE_TERMS;
    Eigen::MatrixXd relative(points, GUIDE_TERMS);
    for (int i = 0; i < points; ++i) {
        const double mu = std::cos(std::numbers::pi * (i + 0.5) / points);
        relative.row(i) = legendre(mu, GUIDE_TERMS).transpose() / mode.phi(mu);
    }
    const Eigen::VectorXd one = Eigen::VectorXd::Ones(points);
    factors = relative.colPivHouseholderQr().solve(one);
    return (relative * factors - one).cwiseAbs().maxCoeff();
}

/// Largest eigenvalue of the symmetric matrix with 0 on its diagonal and the square roots of `off2` beside it, by
/// halving with Sturm's count: a solver for all eigenvalues takes a hundred times as long.
double largest_eigenvalue(const Eigen::VectorXd &off2, double above) {
    const auto exceeded = [&](double x) { // some eigenvalue is larger than x
        double pivot = -x;
        for (int l = 0; l < off2.size() && pivot < 0; ++l) pivot = -x - off2[l] / pivot;
        return pivot >= 0;
    };
    double low = 0, high = above;
    for (int i = 0; i < 100 && high - low > 1e-15 * high; ++i) {
        const double middle = (low + high) / 2;
        (exceeded(middle) ? low : high) = middle;
    }
    return low;
}

double largest(const Eigen::VectorXd &factors) {
    double peak = 0;
    constexpr int points = 1000;
    for (int i = 0; i <= points; ++i) peak = std::max(peak, legendre(2.0 * i / points - 1, GUIDE_TERMS).dot(factors));
    return peak;
}

} // namespace

double Eigenmode::phi(double mu) const {
    const Eigen::VectorXd p = legendre(mu, Eigen::Index(moments.size()));
    double scattered = 0, power = 1;
    for (int l = 0; l < p.size(); ++l, power *= anisotropy) scattered += (2 * l + 1) * power * moments[l] * p[l];
    return albedo * nu / 2 * scattered / (nu - mu);
}

Eigenmode eigenmode(double albedo, double g) {
    const int count = moments_of(g);
    Eigen::VectorXd h(count);
    double power = 1;
    for (int l = 0; l < count; ++l, power *= g) h[l] = (2 * l + 1) * (1 - albedo * power);
    Eigen::VectorXd off2(count - 1);
    for (int l = 1; l < count; ++l) off2[l - 1] = l * l / (h[l] * h[l - 1]);
    const double nu = largest_eigenvalue(off2, 2 * std::sqrt(off2.maxCoeff())); // Gershgorin's circles

    Eigenmode mode{albedo, g, nu, std::vector<double>(count)};
    // l m_(l-1) + (l+1) m_(l+1) = nu h_l m_l, from the top down: the way in which the decaying solution grows.
    std::vector<double> &m = mode.moments;
    m[count - 1] = 1e-200;
    for (int l = count - 1; l > 0; --l) {
        m[l - 1] = (h[l] * mode.nu * m[l] - (l + 1) * (l + 1 < count ? m[l + 1] : 0)) / l;
        if (std::abs(m[l - 1]) > 1e100)
            for (int k = l - 1; k < count; ++k) m[k] *= 1e-150;
    }
    for (int l = count - 1; l >= 0; --l) m[l] /= m[0];
    return mode;
}

GuideMode guide_mode(double albedo, double anisotropy, bool isotropic) {
    const double limit = double(GUIDE_LARGEST_ANISOTROPY);
    const double g = isotropic ? 0 : std::clamp(anisotropy, -limit, limit);
    // Below .4 nu nears 1, and with it 1 / (nu - mu) its pole; at 1 nu is infinite.
    double guided = std::clamp(albedo, 0.4, 1 - 1e-6);
    Eigenmode mode = eigenmode(guided, g);
    Eigen::VectorXd factors;
    constexpr double good = 0.1; // relative error of phi
    while (fit(mode, factors) > good && !isotropic) mode = eigenmode(guided = 1 - 0.8 * (1 - guided), g);

    GuideMode out{};
    for (int l = 0; l < GUIDE_TERMS; ++l) out.phi[l] = float(factors[l]);
    out.peak = float(largest(factors) * (1 + 1e-6));
    out.inverse_nu = float(1 / mode.nu);
    out.spread = float(std::log((mode.nu + 1) / (mode.nu - 1)));
    return out;
}

} // namespace nacre::guide
