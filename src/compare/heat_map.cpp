#include "compare/heat_map.h"
#include "base/parallel.h"
#include <algorithm>
#include <cmath>

namespace nacre::compare {
namespace {

using Rgb = std::array<float, 3>;
using Scores = std::array<double, 3>; // z of each channel

constexpr int around = 3;

/// Of pixels [x0, x1) x [y0, y1), as far as they are in the picture.
Scores scores(const Estimate &a, const Estimate &b, int x0, int y0, int x1, int y1) {
    Scores z{};
    for (int c = 0; c < 3; ++c)
        z[std::size_t(c)] =
            mean_difference(a, b, c, std::max(x0, 0), std::max(y0, 0), std::min(x1, a.width), std::min(y1, a.height))
                .z();
    return z;
}

Scores pixel_scores(const Estimate &a, const Estimate &b, std::size_t pixel) {
    Scores z{};
    if (tested(a, b, pixel))
        for (int c = 0; c < 3; ++c) z[std::size_t(c)] = pixel_difference(a.at(pixel, c), b.at(pixel, c)).z();
    return z;
}

struct Tiles {
    int columns;
    std::vector<Scores> scores; // row by row
    const Scores &at(int x, int y) const {
        return scores[std::size_t(y / tile_size) * std::size_t(columns) + std::size_t(x / tile_size)];
    }
};

Tiles tiles_of(const Estimate &a, const Estimate &b) {
    Tiles tiles{(a.width + tile_size - 1) / tile_size, {}};
    for (int y = 0; y < a.height; y += tile_size)
        for (int x = 0; x < a.width; x += tile_size)
            tiles.scores.push_back(scores(a, b, x, y, x + tile_size, y + tile_size));
    return tiles;
}

/// Calls `color`(x, y, pixel, channels of it) for every pixel of a new picture.
template <typename F> io::Picture painted(const Estimate &like, std::vector<std::string> channels, const F &color) {
    io::Picture map;
    map.width = like.width;
    map.height = like.height;
    map.pixels.resize(like.mean.size() * channels.size());
    parallel_for(std::size_t(like.height), [&](std::size_t y) {
        for (int x = 0; x < like.width; ++x) {
            const std::size_t pixel = y * std::size_t(like.width) + std::size_t(x);
            color(x, int(y), pixel, map.pixels.data() + pixel * channels.size());
        }
    });
    map.channels = std::move(channels);
    return map;
}

double worst(const Scores &z) {
    return *std::max_element(z.begin(), z.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
}

Rgb alarm(double z) { return z > 0 ? Rgb{1, 0.9f, 0} : Rgb{0, 0.9f, 1}; }

Rgb shade(double z, double limit) {
    const auto strength = float(std::min(1.0, z * z / (limit * limit))); // PNG brightens what is dark
    return z > 0 ? Rgb{strength, 0, 0} : Rgb{0, 0, strength};
}

bool on_frame(const Estimate &a, int x, int y) {
    const int across = x % tile_size, down = y % tile_size;
    return across == 0 || down == 0 || across == tile_size - 1 || down == tile_size - 1 || x == a.width - 1 ||
           y == a.height - 1;
}

} // namespace

io::Picture score_map(const Estimate &a, const Estimate &b) {
    const Tiles tiles = tiles_of(a, b);
    return painted(a, {"R", "G", "B", "tile.R", "tile.G", "tile.B"}, [&](int x, int y, std::size_t pixel, float *out) {
        for (const Scores &z : {pixel_scores(a, b, pixel), tiles.at(x, y)}) out = std::copy(z.begin(), z.end(), out);
    });
}

io::Picture heat_map(const Estimate &a, const Estimate &b, const Verdict &verdict) {
    const Tiles tiles = tiles_of(a, b);
    return painted(a, {"R", "G", "B"}, [&](int x, int y, std::size_t pixel, float *out) {
        const double here = worst(pixel_scores(a, b, pixel)), tile = worst(tiles.at(x, y));
        Rgb color;
        if (!finite(a, b, pixel))
            color = {1, 0, 1};
        else if (std::abs(here) > verdict.pixels.limit)
            color = alarm(here);
        else if (std::abs(tile) > verdict.tiles.limit && on_frame(a, x, y))
            color = alarm(tile);
        else
            color =
                shade(worst(scores(a, b, x - around, y - around, x + around + 1, y + around + 1)), verdict.tiles.limit);
        std::copy(color.begin(), color.end(), out);
    });
}

} // namespace nacre::compare
