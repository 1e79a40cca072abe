#include "accel/clearance.h"
#include <algorithm>
#include <cmath>

namespace nacre::accel {
namespace {

/// Flights are drawn with one channel's extinction at a time, each channel's about as often (hero: a third of the walks
/// each). The best cell is a matter of factors, .5 to 2 mean free paths, so the geometric mean serves channels best
/// that are within a factor of 2 of it, as skin's are; the largest would leave the others rays to trace, and the
/// smallest would spend the memory of a hundred times as many cells on them.
float middle(const Vec3f &free_path) { return std::cbrt(free_path.prod()); }

} // namespace

float clearance_cell(const Vec3f &free_path, float size) {
    // Coarser than 1/64 of the object saves nothing: 64^3 cells are 262 kB and built in a blink. Finer than 1/256 is a
    // matter of seconds and of more memory than caches hold.
    return std::clamp(middle(free_path), size / 256, size / 64);
}

// A flight no longer than what fits into the object about its middle, half its size to either side, may be clear. At a
// quarter of the size two steps in three still are traced.
bool clearance_pays(const Vec3f &free_path, float size) { return middle(free_path) < size / 4; }

} // namespace nacre::accel
