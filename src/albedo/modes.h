#pragma once
#include "albedo/ordinates.h"

namespace nacre::albedo {

/// Light deep in a medium, as a sum of parts that decay exponentially with the depth. A column each: the sum and the
/// difference of the densities of collisions inwards and outwards per state, times the root of its weight.
struct Modes {
    Eigen::VectorXd rate; // decay per mean free path
    Eigen::MatrixXd even, odd;
};

/// 0 <= albedo <= 1 - 1e-9.
Modes modes_of(const Ordinates &ordinates, double albedo);

} // namespace nacre::albedo
