#include "scene/closed.h"
#include "scene/weld.h"
#include <algorithm>
#include <unordered_map>

namespace nacre::scene {

bool is_closed(const Mesh &mesh) {
    const std::vector<std::uint32_t> welded = weld(mesh.positions);
    std::unordered_map<std::uint64_t, int> balance;
    balance.reserve(mesh.triangles.size() * 2);
    for (const auto &triangle : mesh.triangles)
        for (int k = 0; k < 3; ++k) {
            const std::uint64_t from = welded[triangle[k]], to = welded[triangle[(k + 1) % 3]];
            if (from == to) continue;
            balance[std::min(from, to) << 32 | std::max(from, to)] += from < to ? 1 : -1;
        }
    return std::all_of(balance.begin(), balance.end(), [](const auto &edge) { return edge.second == 0; });
}

} // namespace nacre::scene
