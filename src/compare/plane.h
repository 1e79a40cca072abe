#pragma once
#include <cstddef>
#include <vector>

namespace nacre::compare {

/// One number per pixel, row 0 at the top.
struct Plane {
    int width = 0, height = 0;
    std::vector<float> values;

    Plane(int width, int height) : width(width), height(height), values(std::size_t(width) * std::size_t(height)) {}
};

/// Weights of the pixels -r ... r around one.
using Taps = std::vector<float>;

/// `plane` filtered with `across`(x) `down`(y); beyond its edges it goes on as its outermost pixels.
Plane filtered(const Plane &plane, const Taps &across, const Taps &down);

} // namespace nacre::compare
