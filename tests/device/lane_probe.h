#pragma once
#include "shared/path.h"
#include "shared/scene.h"
#include <cstdint>
#include <vector>

namespace nacre::test {

/// The numbers of lanes that kernels are compiled for.
inline constexpr int lane_counts[] = {1, 4, 8, 16};

/// What probe_function of kernels/probe_lanes.cl computes.
enum class Function : std::uint32_t {
    log,
    exp,
    log1p,
    expm1,
    sine,
    cosine,
    unit,
    root,
    inverse,
    square_less_one,
    floor,
    atan2_x_1,
    atan2_1_x,
    length3,
    normalised3
};

/// Runs kernels of probe_lanes.cl on `in`, whose size must be a multiple of 2^12 (any LANES, any work-group); floats go
/// in and come out by their bits.
std::vector<std::uint32_t> run_function(int lanes, Function function, const std::vector<std::uint32_t> &in);
std::vector<std::uint32_t> run_lane_hash(int lanes, const std::vector<std::uint32_t> &in); // [8][in.size()]
std::vector<std::uint32_t> run_lane_walk(int lanes, const std::vector<std::uint32_t> &in,
                                         shared::ChannelSampling sampling); // [12][in.size()]

} // namespace nacre::test
