#pragma once
#include "albedo/returned.h"
#include <vector>

namespace nacre::render {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Of a medium for tables of what it returns: flights of up to a million mean free paths, and cosines enough for shares
/// within 1e-4.
albedo::Ordinates returned_ordinates(double g, double bleed, shared::FlightLaw law);

/// Logarithms of the shares, depths x cosines (evenly from -1 to 1, or 0 alone). Depths are in mean free paths.
Rows returned_layer(const albedo::Returned &returned, const std::vector<double> &depths, Eigen::Index cosines);

} // namespace nacre::render
