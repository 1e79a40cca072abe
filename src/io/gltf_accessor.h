#pragma once
#include "io/gltf_file.h"
#include <cstdint>
#include <vector>

namespace nacre::io {

/// The numbers of accessor `index`, `width` per element (integers as shares where it says they are normalised).
/// Throws Error{Exit::input} where it is of another width or anything it names is out of range.
std::vector<double> read_accessor(const GltfFile &file, int index, int width);

} // namespace nacre::io
