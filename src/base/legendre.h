#pragma once
#include <Eigen/Core>

namespace nacre {

/// Legendre polynomials P_0 .. P_(count - 1) at mu.
inline Eigen::VectorXd legendre(double mu, Eigen::Index count) {
    Eigen::VectorXd p = Eigen::VectorXd::Ones(count);
    if (count > 1) p[1] = mu;
    for (Eigen::Index l = 2; l < count; ++l)
        p[l] = (double(2 * l - 1) * mu * p[l - 1] - double(l - 1) * p[l - 2]) / double(l);
    return p;
}

} // namespace nacre
