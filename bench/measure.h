#pragma once
#include "base/error.h"
#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace nacre::bench {

/// Seconds by two clocks: what the user waits, and what all threads of this process computed. The second does not count
/// other programs on the machine, but neither does it count a thread of ours that has nothing to do.
struct Seconds {
    double wall = 0, cpu = 0;
};

inline double clock_seconds(clockid_t clock) {
    timespec now;
    clock_gettime(clock, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

inline double cpu_seconds() { return clock_seconds(CLOCK_PROCESS_CPUTIME_ID); }
inline double wall_seconds() { return clock_seconds(CLOCK_MONOTONIC); }

template <typename Work> Seconds seconds(const Work &work) {
    const Seconds start{wall_seconds(), cpu_seconds()};
    work();
    return {wall_seconds() - start.wall, cpu_seconds() - start.cpu};
}

/// The upper one of the two in the middle where the count is even. `values` is not empty.
inline double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
    return values[values.size() / 2];
}

inline double geometric_mean(std::span<const double> values) {
    double sum = 0;
    for (const double value : values) sum += std::log(value);
    return std::exp(sum / double(values.size()));
}

/// Throws Error{Exit::output}.
inline void write_json(const std::string &file, const nlohmann::json &json) {
    std::ofstream out(file);
    if (!(out << json.dump(2) << '\n' << std::flush)) throw Error(Exit::output, file, "cannot be written");
}

} // namespace nacre::bench
