#pragma once
#include "base/vector.h"
#include <cmath>
#include <cstdint>

namespace nacre::reference {

/// Bilinear mean of `texel(x, y)` about (x, y), in texels; the middle of the first is at (.5, .5).
template <typename Texel> Vec3 bilinear(double x, double y, const Texel &texel) {
    const double left = std::floor(x - 0.5), top = std::floor(y - 0.5), s = x - 0.5 - left, t = y - 0.5 - top;
    const auto i = std::int64_t(left), j = std::int64_t(top);
    return (1 - t) * ((1 - s) * texel(i, j) + s * texel(i + 1, j)) +
           t * ((1 - s) * texel(i, j + 1) + s * texel(i + 1, j + 1));
}

inline std::int64_t repeated(std::int64_t i, std::int64_t count) { return (i % count + count) % count; }

} // namespace nacre::reference
