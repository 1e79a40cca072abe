#pragma once
#include "compare/significance.h"

namespace nacre::compare {

/// The z of every pixel and of the tile it is in, signed (> 0: A is brighter), in the channels R, G, B and tile.R,
/// tile.G, tile.B: to be written as EXR. 0 where nothing was tested.
io::Picture score_map(const Estimate &a, const Estimate &b);

/// The same to look at, as linear RGB to be written as PNG at exposure 0. Red where A is brighter over the 7 x 7 pixels
/// around (in the channel where that is clearest), blue where B is, the stronger the nearer z is to the limit of tiles;
/// single pixels cannot be seen through noise. Yellow (A brighter) and cyan (B) are pixels beyond their own limit and
/// the frames of tiles beyond theirs. Pixels that are not finite are magenta.
io::Picture heat_map(const Estimate &a, const Estimate &b, const Verdict &verdict);

} // namespace nacre::compare
