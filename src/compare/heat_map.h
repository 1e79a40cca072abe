#pragma once
#include "compare/significance.h"

namespace nacre::compare {

/// The differences of two tested pictures as a picture. `as_numbers` (EXR): R, G, B and tile.R, tile.G, tile.B hold the
/// signed z of every pixel and of the tile it is in. Otherwise (PNG, exposure 0) colours of each pixel's worst channel:
/// red where A is brighter, blue where B is, the stronger the nearer to the limit, yellow and cyan beyond it; tiles
/// beyond theirs have a frame of these colours. Pixels that are not finite are magenta.
io::Picture heat_map(const Estimate &a, const Estimate &b, const Verdict &verdict, bool as_numbers);

} // namespace nacre::compare
