#pragma once
#include "shared/counters.h"
#include <array>
#include <cstdint>
#include <span>

namespace nacre::render {

/// What kernels compiled with -DPROFILE counted.
struct Profile {
    std::array<std::uint64_t, shared::PROFILE_COUNT> counters{};
    std::array<std::uint64_t, PROFILE_BINS> histogram{}; // walks that have ended, by their steps: see first_of_bin
    std::uint64_t most_steps = 0;

    std::uint64_t operator[](shared::ProfileCounter counter) const { return counters[counter]; }

    /// Adds what came from the device: PROFILE_WORDS words, as shared/counters.h lays them out.
    void add(std::span<const shared::uint> words);

    /// Walks in the histogram.
    std::uint64_t walks() const;
    /// Steps that this share (0 to 1) of the walks do not exceed; within a bin as if its walks were spread evenly, so
    /// exact up to 7 and otherwise to a quarter of an octave. 0 without walks.
    double percentile(double share) const;
};

/// Least number of steps in a bin of the histogram; the inverse of `profile_bin` in path/count.h.
std::uint64_t first_of_bin(std::uint32_t bin);

} // namespace nacre::render
