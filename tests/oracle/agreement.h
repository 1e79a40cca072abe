#pragma once
#include "io/image.h"
#include "oracle/reference.h"
#include <array>
#include <string>

namespace nacre::reference {

/// How far two independent pictures of one scene are apart, in standard errors of the difference.
struct Agreement {
    double pixel = 0;                   // the largest of all pixels and channels
    double tile = 0;                    // the same for means over tiles of 4 x 4 pixels
    double all = 0;                     // the mean over the picture and its channels
    std::array<double, 3> whole{};      // means over the picture
    std::array<double, 3> difference{}; // of these means, relative
    std::array<double, 3> error{};      // its standard error
    int x = 0, y = 0, channel = 0;      // where `pixel` is
};

/// `picture` has the layer `variance`. Both errors count; so does 2e-6 of a pixel's value, which float sums may lose.
/// The variances of pixels and tiles are pooled with those of pixels near by where these are larger.
Agreement compare(const io::Picture &picture, const Image &reference);

/// The deviation, in standard errors, that the largest of `count` independent normal ones exceeds with probability 1e-4
/// (Šidák 1967).
double largest_deviation(std::size_t count);

} // namespace nacre::reference
