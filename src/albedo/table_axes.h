#pragma once
#include "albedo/table.h"
#include <algorithm>
#include <cmath>
#include <numbers>

// Where the table's nodes are, each axis by a coordinate in which similarity is smooth and nodes are evenly spaced.
namespace nacre::albedo {

/// Dense at both ends of g, where the phase function has its peaks.
inline double anisotropy_at(double node) {
    const double angle = std::numbers::pi * (node / (table_anisotropies - 1) - 0.5);
    return (least_anisotropy + largest_anisotropy) / 2 + (largest_anisotropy - least_anisotropy) / 2 * std::sin(angle);
}
inline double node_of_anisotropy(double g) {
    const double x = (2 * g - least_anisotropy - largest_anisotropy) / (largest_anisotropy - least_anisotropy);
    return (std::asin(std::clamp(x, -1.0, 1.0)) / std::numbers::pi + 0.5) * (table_anisotropies - 1);
}

inline double bleed_at(double node) { return largest_bleed * std::pow(node / (table_bleeds - 1), 2); }
inline double node_of_bleed(double bleed) {
    return std::sqrt(std::clamp(bleed / largest_bleed, 0.0, 1.0)) * (table_bleeds - 1);
}

/// Dense at black, where forward scattering bends the curve, and at white, where similarities of reciprocal flights
/// with bleed are powers of small numbers.
inline double color_at(double node) {
    const double at = node / (table_colors - 1);
    return 1 - std::pow(1 - at * at, 2);
}
inline double node_of_color(double color) { return std::sqrt(1 - std::sqrt(1 - color)) * (table_colors - 1); }

/// The table holds similarity ^ (1 / power): for reciprocal flights similarity goes like (1 - color)^((1 + bleed) / 2)
/// near white where bleed > 1, else like 1 - color. This goes smoothly from one to the other.
inline double table_power(double bleed, shared::FlightLaw law) {
    return law == shared::FLIGHT_RECIPROCAL ? (1 + std::sqrt(1 + bleed * bleed)) / 2 : 1;
}

inline std::size_t table_index(shared::FlightLaw law, shared::Entry entry, int anisotropy, int bleed) {
    const int first = law == shared::FLIGHT_RECIPROCAL ? 2 : 0, second = entry == shared::ENTRY_UNIFORM ? 1 : 0;
    return std::size_t(((first + second) * table_anisotropies + anisotropy) * table_bleeds + bleed) * table_colors;
}

} // namespace nacre::albedo
