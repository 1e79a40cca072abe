#include "scene/weld.h"
#include <algorithm>
#include <numeric>
#include <tuple>

namespace nacre::scene {

std::vector<std::uint32_t> weld(const std::vector<Vec3> &positions) {
    // Sorting beats a hash table here: no choice of hash, and -0 == 0 comes for free.
    const auto key = [&](std::uint32_t i) {
        const Vec3 &p = positions[i];
        return std::make_tuple(p.x(), p.y(), p.z());
    };
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const auto key_a = key(a), key_b = key(b);
        return key_a != key_b ? key_a < key_b : a < b;
    });
    std::vector<std::uint32_t> first(positions.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && positions[order[i]] == positions[order[i - 1]];
        first[order[i]] = same ? first[order[i - 1]] : order[i];
    }
    return first;
}

} // namespace nacre::scene
