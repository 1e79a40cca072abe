#pragma once
#include <array>
#include <span>

namespace nacre::render {

/// What the samples of a pixel say of it, per channel: their mean and the variance of that mean.
struct MeasuredPixel {
    std::array<double, 3> mean, variance;
};

/// What is added to the square of a mean before a variance is divided by it, in pictures with the mean `level`: as in
/// relMSE (compare/metrics.h), so that the dark counts too and black does not divide by 0.
double noise_floor(double level);

/// The sum over the pixels of a tile of variance / (mean^2 + floor), mean over the channels: what they contribute to
/// the picture's relMSE. Pixels with numbers that no float holds count for nothing.
double relative_noise(std::span<const MeasuredPixel> tile, double floor);

} // namespace nacre::render
