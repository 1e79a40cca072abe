#pragma once
#include "device/context.h"
#include "guiding/guide_scenes.h"
#include <optional>
#include <span>

namespace nacre::bench {

struct Estimator {
    shared::Guiding guiding;
    shared::ChannelSampling sampling;
    bool control = false; // walks have a control variate
};

/// "eigen_hero", "eigen_hero_control".
std::string name_of(const Estimator &estimator);

/// Weights of single samples, the channels' largest: only flat patches show them.
struct Weights {
    double largest = 0, percentile = 0; // the 99.99th
};

struct Figures {
    Estimator estimator;
    double seconds = 0;  // of kernels per sample of a pixel: the median
    double variance = 0; // of the luminance per sample: what a pixel's variance is, times its samples
    double relative = 0; // that over the square of the pixel's mean and .01 of the picture's: not ruled by highlights
    double flights = 0;  // per walk
    std::optional<Weights> weights;

    double cost() const { return seconds * variance; }
};

/// Renders the scene with every estimator, in turns, `runs` times after a first that does not count.
std::vector<Figures> measure(const device::Device &device, const Scenario &scenario,
                             std::span<const Estimator> estimators, std::uint32_t samples, int runs);

/// Variance alone, as in Figures; every sample has a camera ray of its own.
double variance_of(const device::Device &device, const Scenario &scenario, const Estimator &estimator,
                   std::uint32_t samples);

} // namespace nacre::bench
