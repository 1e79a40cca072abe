#pragma once
#include "compare/estimate.h"

namespace nacre::compare {

/// How far A is from B, the reference, over R, G and B of all pixels (linear, unclamped) whose numbers are finite in
/// both.
struct Metrics {
    double mse = 0; // mean of (A - B)^2
    double relmse =
        0; // mean of (A - B)^2 / (B^2 + .01 m^2), m the mean of B: the dark counts too, black does not divide by 0
    double psnr = 0; // dB: 10 log10(peak^2 / mse), peak the largest value of B; infinite where A is B
};

Metrics metrics(const Estimate &a, const Estimate &b);

} // namespace nacre::compare
