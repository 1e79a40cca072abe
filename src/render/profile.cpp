#include "render/profile.h"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace nacre::render {

using namespace shared;

std::uint64_t first_of_bin(std::uint32_t bin) { return bin < 4 ? bin : std::uint64_t(4 + bin % 4) << (bin / 4 - 1); }

void Profile::add(std::span<const uint> words) {
    for (std::size_t slice = 0; slice < COUNTER_SLICES; ++slice) {
        const auto part = words.subspan(PROFILE_TAIL + slice * PROFILE_STRIDE, PROFILE_USED);
        for (std::size_t i = 0; i < counters.size(); ++i) counters[i] += part[i];
        for (std::size_t i = 0; i < histogram.size(); ++i) histogram[i] += part[PROFILE_HISTOGRAM + i];
        most_steps = std::max<std::uint64_t>(most_steps, part[PROFILE_MOST_STEPS]);
    }
}

std::uint64_t Profile::walks() const { return std::accumulate(histogram.begin(), histogram.end(), std::uint64_t(0)); }

double Profile::percentile(double share) const {
    const double rank = std::max(1.0, std::ceil(share * double(walks()))); // of the walk asked for, from 1
    double before = 0;
    for (std::uint32_t bin = 0; bin < PROFILE_BINS; ++bin) {
        const double count = double(histogram[bin]);
        if (before + count >= rank) {
            const double first = double(first_of_bin(bin)), width = double(first_of_bin(bin + 1)) - first;
            return std::min(double(most_steps), std::floor(first + width * (rank - before - 0.5) / count));
        }
        before += count;
    }
    return 0;
}

} // namespace nacre::render
