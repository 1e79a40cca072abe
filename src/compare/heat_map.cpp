#include "compare/heat_map.h"
#include <algorithm>
#include <cmath>

namespace nacre::compare {
namespace {

using Rgb = std::array<float, 3>;
using Scores = std::array<double, 3>;

bool tested(const Estimate &a, const Estimate &b, std::size_t pixel) {
    return a.samples[pixel] >= 1 && b.samples[pixel] >= 1;
}

Scores pixel_scores(const Estimate &a, const Estimate &b, std::size_t pixel) {
    Scores z{};
    if (finite(a, b, pixel) && tested(a, b, pixel))
        for (int c = 0; c < 3; ++c) z[std::size_t(c)] = pixel_difference(a.at(pixel, c), b.at(pixel, c)).z();
    return z;
}

/// Of all tiles, row by row.
std::vector<Scores> tile_scores(const Estimate &a, const Estimate &b) {
    std::vector<Scores> tiles;
    for (int y = 0; y < a.height; y += tile_size)
        for (int x = 0; x < a.width; x += tile_size) {
            Scores &z = tiles.emplace_back();
            for (int c = 0; c < 3; ++c)
                z[std::size_t(c)] =
                    mean_difference(a, b, c, x, y, std::min(x + tile_size, a.width), std::min(y + tile_size, a.height))
                        .z();
        }
    return tiles;
}

double worst(const Scores &z) {
    return *std::max_element(z.begin(), z.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
}

Rgb alarm(double z) { return z > 0 ? Rgb{1, 0.9f, 0} : Rgb{0, 0.9f, 1}; }

Rgb shade(double z, double limit) {
    if (std::abs(z) > limit) return alarm(z);
    const auto strength = float(std::abs(z) / limit);
    return z > 0 ? Rgb{strength, 0, 0} : Rgb{0, 0, strength};
}

bool on_frame(const Estimate &a, int x, int y) {
    return x % tile_size == 0 || y % tile_size == 0 || x % tile_size == tile_size - 1 ||
           y % tile_size == tile_size - 1 || x == a.width - 1 || y == a.height - 1;
}

} // namespace

io::Picture heat_map(const Estimate &a, const Estimate &b, const Verdict &verdict, bool as_numbers) {
    io::Picture map;
    map.width = a.width;
    map.height = a.height;
    map.channels = {"R", "G", "B"};
    if (as_numbers) map.channels.insert(map.channels.end(), {"tile.R", "tile.G", "tile.B"});
    const std::vector<Scores> tiles = tile_scores(a, b);
    const int columns = (a.width + tile_size - 1) / tile_size;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            const std::size_t pixel = std::size_t(y) * std::size_t(a.width) + std::size_t(x);
            const Scores z = pixel_scores(a, b, pixel);
            const Scores &tile = tiles[std::size_t(y / tile_size * columns + x / tile_size)];
            if (as_numbers) {
                for (const Scores &scores : {z, tile})
                    map.pixels.insert(map.pixels.end(), scores.begin(), scores.end());
                continue;
            }
            Rgb color = shade(worst(z), verdict.pixels.limit);
            if (std::abs(worst(tile)) > verdict.tiles.limit && on_frame(a, x, y)) color = alarm(worst(tile));
            if (!finite(a, b, pixel)) color = {1, 0, 1};
            map.pixels.insert(map.pixels.end(), color.begin(), color.end());
        }
    return map;
}

} // namespace nacre::compare
