#pragma once
#include <cmath>

namespace nacre::io {

// The transfer curve of IEC 61966-2-1, both ways, with the standard's own constants; encoded and linear are 0..1.

inline double srgb_to_linear(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

inline double linear_to_srgb(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

} // namespace nacre::io
