#pragma once
#include "io/image.h"
#include <string>
#include <vector>

namespace nacre::sheet {

/// A rendered panel and what is written below it.
struct Tile {
    io::Picture picture; // linear, its first three channels; without pixels it is shown black
    double exposure = 0; // stops
    std::string label;
    std::vector<std::string> settings; // as many to a line as fit below the picture
    std::string cost;
};

// Pixels around and between tiles.
constexpr int sheet_margin = 16, tile_gap = 12;

/// Tiles in rows of `columns`, left to right, with their captions, below the title: linear RGB, to be written as PNG at
/// exposure 0. All tiles have the same size. Captions are in the metadata too: "title", "panel.0", …
io::Picture contact_sheet(const std::string &title, std::size_t columns, const std::vector<Tile> &tiles);

} // namespace nacre::sheet
