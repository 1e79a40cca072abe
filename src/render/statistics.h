#pragma once
#include "shared/counters.h"
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace nacre::render {

/// What a render did and what it cost. Seconds are wall time but for `sampling`, which is that of the kernels alone.
struct Statistics {
    double load = 0, build = 0, compile = 0, first_pixel = 0, sampling = 0, total = 0;
    std::uint64_t samples = 0;
    std::vector<std::pair<std::string, std::size_t>> memory; // bytes by buffer
    std::vector<std::string> features;
    std::array<std::uint64_t, shared::COUNTER_COUNT> counters{};
    std::string device, program_options;
    bool generic = false;
    std::uint64_t bad_pixel_x = 0, bad_pixel_y = 0, bad_sample = 0, bad_step = 0; // first NaN or infinity, if any

    std::uint64_t operator[](shared::Counter counter) const { return counters[counter]; }

    /// All rays that were traced.
    std::uint64_t rays() const;
    /// The document of `--stats`.
    std::string json() const;
    /// What a user must know: energy lost, walks that slipped through, NaNs. One line each.
    std::vector<std::string> remarks() const;
};

} // namespace nacre::render
