#pragma once
#include "compare/metrics.h"
#include "compare/significance.h"
#include <optional>
#include <string>

namespace nacre::app {

/// What `nacre compare` has to say.
struct Comparison {
    std::string file_a, file_b;
    io::Picture a, b; // for their size, place and metadata
    compare::Metrics metrics;
    double flip = 0, flip_largest = 0;
    int flip_x = 0, flip_y = 0;              // where it is largest
    std::optional<compare::Verdict> verdict; // none: a picture has no noise to test by
    double samples_a = 0, samples_b = 0;     // per pixel, their mean
    std::vector<std::string> remarks;
};

std::string as_text(const Comparison &comparison);
std::string as_json(const Comparison &comparison);

} // namespace nacre::app
