#include "render/alias.h"
#include <numeric>

namespace nacre::render {

std::vector<shared::AliasEntry> alias_table(std::span<const double> weights) {
    const std::size_t count = weights.size();
    std::vector<shared::AliasEntry> table(count);
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    std::vector<double> scaled(count, 1.0);
    if (total > 0)
        for (std::size_t i = 0; i < count; ++i) scaled[i] = weights[i] / total * double(count);
    std::vector<std::uint32_t> small, large;
    for (std::size_t i = 0; i < count; ++i) (scaled[i] < 1 ? small : large).push_back(std::uint32_t(i));
    for (std::size_t i = 0; i < count; ++i) table[i] = {1.0f, std::uint32_t(i)};
    while (!small.empty() && !large.empty()) {
        const std::uint32_t low = small.back(), high = large.back();
        small.pop_back();
        table[low] = {float(scaled[low]), high};
        scaled[high] -= 1 - scaled[low];
        if (scaled[high] < 1) {
            large.pop_back();
            small.push_back(high);
        }
    }
    return table;
}

} // namespace nacre::render
