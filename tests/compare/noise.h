#pragma once
#include "compare/estimate.h"
#include <cstdint>

namespace nacre {

/// Pictures made of noise as path tracers have it: samples of a pixel are drawn from one of several laws with heavy
/// tails or few values, which the pixel's place alone chooses, so that two pictures with other seeds show the same.
struct Noise {
    int width = 24, height = 24;
    double brighter = 1; // times all samples
};

/// `spp` samples a pixel, R, G and B independent; the variance is what a film stores.
compare::Estimate noisy(const Noise &noise, int spp, std::uint64_t seed);

} // namespace nacre
