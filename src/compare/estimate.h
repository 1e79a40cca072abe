#pragma once
#include "io/image.h"
#include <array>
#include <string>
#include <vector>

namespace nacre::compare {

/// One channel of one pixel as a measurement: the mean of `samples` samples, the variance of that mean, and what of the
/// mean is no noise but rounding.
struct Measured {
    double mean, variance, samples, rounding;
};

/// A picture as measurements, row 0 at the top. Means are linear RGB, in the picture's own unit.
struct Estimate {
    int width = 0, height = 0;
    std::vector<std::array<float, 3>> mean;
    std::vector<std::array<float, 3>> variance; // of the mean; empty where the picture has no such layer
    std::vector<float> samples;                 // empty where the picture has no such layer

    double level = 0; // mean of all |R|, |G|, |B| that are finite

    bool has_noise() const { return !variance.empty() && !samples.empty(); }
    Measured at(std::size_t pixel, int channel) const;
};

/// The channels R, G, B, `variance.*` and `samples` of `picture`; `name` is for messages. Throws Error{Exit::input}
/// where one of the first three is missing.
Estimate estimate_of(const io::Picture &picture, const std::string &name);

/// Throws Error{Exit::input} unless both have the same size and the same place in the whole image.
void check_same_window(const io::Picture &a, const std::string &name_a, const io::Picture &b,
                       const std::string &name_b);

} // namespace nacre::compare
