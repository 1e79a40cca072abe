#pragma once
#include "albedo/memo.h"
#include "patch/survey.h"
#include <string>

namespace nacre::patch {

/// Albedo over colour for some anisotropies: what was measured as dots, the fit as lines. An SVG document.
std::string plot_fit(const Survey &survey, const albedo::MemoFit &fit, const std::string &title);

} // namespace nacre::patch
