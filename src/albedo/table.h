#pragma once
#include "shared/scene.h"
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace nacre::albedo {

/// Similarities by flight law, entry (lambert, uniform), g, bleed and colour: what `nacre albedo build` writes and the
/// program carries.
inline constexpr int table_anisotropies = 20, table_bleeds = 12, table_colors = 33;
inline constexpr std::size_t table_size = std::size_t(2) * 2 * table_anisotropies * table_bleeds * table_colors;
inline constexpr double least_anisotropy = -0.95, largest_anisotropy = 0.98, largest_bleed = 4;

/// Makes the table from the solver, on all cores; minutes. `progress` is told the share that is done and may throw to
/// stop.
std::vector<float> build_table(const std::function<void(double)> &progress);

/// As bytes of a file (little-endian floats after a line that says what it is), and back; throws std::runtime_error
/// where it is none.
std::string table_file(std::span<const float> table);
std::vector<float> read_table(std::string_view file);

/// The table that the program carries.
std::span<const float> built_in_table();

/// Similarity of the medium of a half-space that shows `color`, in [0, 1], falling in `color`, 1 for 0 and 0 for 1. g
/// and bleed beyond the table's are taken as its ends; entries other than uniform as lambert.
double table_similarity(std::span<const float> table, double color, double g, double bleed, shared::FlightLaw law,
                        shared::Entry entry);

} // namespace nacre::albedo
