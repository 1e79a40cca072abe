#include "compare/plane.h"
#include "base/parallel.h"
#include <algorithm>

namespace nacre::compare {

// Tap by tap over whole rows, which compilers make vectors of.
Plane filtered(const Plane &plane, const Taps &across, const Taps &down) {
    const int w = plane.width, h = plane.height;
    const int rx = int(across.size()) / 2, ry = int(down.size()) / 2;
    Plane half(w, h), result(w, h);
    parallel_for(std::size_t(h), [&](std::size_t y) {
        std::vector<float> row(std::size_t(w + 2 * rx));
        const float *from = plane.values.data() + y * std::size_t(w);
        for (int x = -rx; x < w + rx; ++x) row[std::size_t(x + rx)] = from[std::clamp(x, 0, w - 1)];
        float *to = half.values.data() + y * std::size_t(w);
        for (std::size_t tap = 0; tap < across.size(); ++tap)
            for (int x = 0; x < w; ++x) to[x] += across[tap] * row[std::size_t(x) + tap];
    });
    parallel_for(std::size_t(h), [&](std::size_t y) {
        float *to = result.values.data() + y * std::size_t(w);
        for (int tap = 0; tap < int(down.size()); ++tap) {
            const int row = std::clamp(int(y) + tap - ry, 0, h - 1);
            const float *from = half.values.data() + std::size_t(row) * std::size_t(w);
            for (int x = 0; x < w; ++x) to[x] += down[std::size_t(tap)] * from[x];
        }
    });
    return result;
}

} // namespace nacre::compare
