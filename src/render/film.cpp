#include "render/film.h"
#include "shared/path.h"
#include <algorithm>
#include <cmath>

namespace nacre::render {

using namespace shared;

std::uint32_t Layers::planes() const {
    return FILM_PLANES + (surface() ? FILM_SURFACE_PLANES : 0) + (scatter() ? FILM_SCATTER_PLANES : 0);
}

std::uint32_t Layers::kept() const { return (surface() ? LAYERS_SURFACE : 0) + (scatter() ? LAYERS_SCATTER : 0); }

Film::Film(const Crop &crop, std::uint32_t planes)
    : crop(crop), planes(planes), columns((crop.width() + TILE - 1) / TILE),
      count(columns * ((crop.height() + TILE - 1) / TILE) * TILE * TILE), sums(std::size_t(count) * planes * 4),
      samples(count) {}

std::uint32_t Film::tile_index(std::uint32_t x, std::uint32_t y) const {
    return ((y / TILE) * columns + x / TILE) * TILE * TILE + (y % TILE) * TILE + x % TILE;
}

void Film::add(const std::vector<float4> &block) {
    for (std::size_t i = 0; i < block.size(); ++i) {
        sums[4 * i] += block[i].x;
        sums[4 * i + 1] += block[i].y;
        sums[4 * i + 2] += block[i].z;
        sums[4 * i + 3] += block[i].w;
    }
}

void Film::count_samples(std::uint32_t first, std::uint32_t pixel_count, std::uint32_t more) {
    for (std::uint32_t i = first; i < first + pixel_count; ++i) samples[i] += more;
}

std::uint64_t Film::total_samples() const {
    std::uint64_t total = 0;
    for (std::uint32_t y = 0; y < crop.height(); ++y)
        for (std::uint32_t x = 0; x < crop.width(); ++x) total += samples[tile_index(x, y)];
    return total;
}

io::Picture Film::picture(const Layers &layers, double unit, double length) const {
    io::Picture picture;
    picture.width = int(crop.width());
    picture.height = int(crop.height());
    picture.crop_x = int(crop.x0);
    picture.crop_y = int(crop.y0);
    picture.channels = {"R", "G", "B", "A"};
    const auto layer = [&](bool wanted, std::initializer_list<const char *> names) {
        if (wanted) picture.channels.insert(picture.channels.end(), names.begin(), names.end());
    };
    layer(layers.albedo, {"albedo.R", "albedo.G", "albedo.B"});
    layer(layers.normal, {"N.X", "N.Y", "N.Z"});
    layer(layers.depth, {"depth.Z"});
    layer(layers.variance, {"variance.R", "variance.G", "variance.B"});
    layer(layers.samples, {"samples"});
    layer(layers.zero, {"subsurface.zero.R", "subsurface.zero.G", "subsurface.zero.B"});
    layer(layers.single, {"subsurface.single.R", "subsurface.single.G", "subsurface.single.B"});
    layer(layers.multiple, {"subsurface.multiple.R", "subsurface.multiple.G", "subsurface.multiple.B"});
    layer(layers.steps, {"walk.steps"});
    picture.pixels.reserve(picture.channels.size() * crop.width() * crop.height());

    for (std::uint32_t y = 0; y < crop.height(); ++y)
        for (std::uint32_t x = 0; x < crop.width(); ++x) {
            const std::uint32_t pixel = tile_index(x, y);
            const double *sum = sums.data() + std::size_t(pixel) * planes * 4;
            const double n = samples[pixel], scale = n > 0 ? 1 / n : 0;
            const double hits = sum[3]; // samples that met geometry: depth is their mean
            const auto put = [&](double value) { picture.pixels.push_back(float(value)); };
            const auto mean = [&](int c) { // infinity leaves no rest, but NaN
                const double rest = sum[4 * FILM_REST + c];
                return (std::isfinite(rest) ? sum[c] + rest : sum[c]) * scale;
            };
            for (int c = 0; c < 3; ++c) put(mean(c) * unit);
            put(mean(3));
            const double *square = sum + 4 * FILM_SQUARE;
            const double *albedo = sum + 4 * FILM_PLANES, *normal = albedo + 4;
            const double *orders = sum + 4 * (FILM_PLANES + (layers.surface() ? FILM_SURFACE_PLANES : 0));
            if (layers.albedo)
                for (int c = 0; c < 3; ++c) put(albedo[c] * scale);
            if (layers.normal)
                for (int c = 0; c < 3; ++c) put(normal[c] * scale);
            if (layers.depth) put(hits > 0 ? albedo[3] / hits * length : 0);
            if (layers.variance) // of the mean, from the samples' own spread; 0 where it cannot be known
                for (int c = 0; c < 3; ++c) {
                    const double variance = std::max(0.0, square[c] * scale - mean(c) * mean(c));
                    put(n > 1 ? variance / (n - 1) * unit * unit : 0);
                }
            if (layers.samples) put(n);
            const bool wanted[] = {layers.zero, layers.single, layers.multiple};
            for (int order = 0; order < FILM_SCATTER_PLANES; ++order)
                for (int c = 0; c < 3 && wanted[order]; ++c) put(orders[4 * order + c] * scale * unit);
            if (layers.steps) put(orders[3] > 0 ? orders[7] / orders[3] : 0); // scatters by walks
        }
    return picture;
}

} // namespace nacre::render
