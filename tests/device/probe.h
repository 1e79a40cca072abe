#pragma once
#include "device/program.h"
#include "shared/guide.h"
#include "shared/scene.h"
#include <array>
#include <cstdint>
#include <vector>

namespace nacre::test {

/// The argument `Probe` of kernels/probe.cl, field by field.
struct Probe {
    shared::float4 sigma{1, 1, 1, 0}, albedo{};
    shared::float4 walk_anisotropy{}; // per channel; run_walks takes `anisotropy` for all where w is 0
    float anisotropy = 0, bleed = 0;
    float thickness = 0;       // slab; 0: half-space; < 0: sphere of radius -thickness
    float a = 0, b = 0, c = 0; // a: of guided walks, light on the far side over that on the near side
    std::uint32_t seed = 1, first = 0, reciprocal = 0, entry = shared::ENTRY_LAMBERT, count = 1;
    std::uint32_t cap = 0; // walks end after so many scatters, 0: never
};

/// Runs a kernel of probe.cl with the features that the probe needs and `features`; returns `items` x `width` floats.
/// `initial`: what the kernel finds there, for those that read.
std::vector<float> run_probe(const char *kernel, const Probe &probe, std::size_t items, std::size_t width,
                             shared::ChannelSampling sampling = shared::CHANNEL_HERO, std::uint32_t features = 0,
                             const std::vector<float> &initial = {}, const std::vector<shared::GuideMode> &modes = {});

/// A mean and its standard error.
struct Estimate {
    double mean = 0, error = 0;
};

/// Walks in a body with a known answer.
struct Walks {
    std::array<Estimate, 3> near, far;   // per channel: leaving on the side of the entry, on the other side
    Estimate unscattered, length;        // share that never scattered; length of the way, channel 0
    std::array<Estimate, 8> by_scatters; // share that leaves after n scatters (either side)
    double largest = 0;                  // weight
};

/// `walks` of them, each work-item's mean taken as one sample of the statistics.
Walks run_walks(Probe probe, std::uint32_t walks, shared::ChannelSampling sampling = shared::CHANNEL_HERO,
                shared::Guiding guiding = shared::GUIDING_NONE);

/// As many walks (in steps of 2^17, seed after seed) as `near` and `far` of every channel need for this standard error;
/// it gives up, with a larger error, where that takes a variance of more than 25.
Walks run_walks_to(Probe probe, double largest_error, shared::ChannelSampling sampling = shared::CHANNEL_HERO,
                   shared::Guiding guiding = shared::GUIDING_NONE);

/// Expects `estimate` within 4 of its standard errors of `exact`, and the error small enough to mean something.
void expect_exact(const Estimate &estimate, double exact, double largest_error, const char *what);

} // namespace nacre::test
