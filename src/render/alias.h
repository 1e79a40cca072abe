#pragma once
#include "shared/scene.h"
#include <span>
#include <vector>

namespace nacre::render {

/// Alias table (Walker 1977, Vose 1991) for drawing index i in proportion to weights[i] >= 0 with two random numbers.
/// All weights 0: every index alike.
std::vector<shared::AliasEntry> alias_table(std::span<const double> weights);

} // namespace nacre::render
