#include "render/film.h"
#include "render/tile_noise.h"
#include "shared/path.h"
#include <algorithm>
#include <cmath>

namespace nacre::render {

using namespace shared;

double whole_sum(double sum, double rest) { return std::isfinite(rest) ? sum + rest : sum; }

std::uint32_t Layers::planes() const {
    return FILM_PLANES + (surface() ? FILM_SURFACE_PLANES : 0) + (scatter() ? FILM_SCATTER_PLANES : 0);
}

std::uint32_t Layers::kept() const { return (surface() ? LAYERS_SURFACE : 0) + (scatter() ? LAYERS_SCATTER : 0); }

Film::Film(const Crop &crop, std::uint32_t planes, std::uint32_t halves)
    : crop(crop), planes(planes), columns((crop.width() + TILE - 1) / TILE),
      count(columns * ((crop.height() + TILE - 1) / TILE) * TILE * TILE), halves(halves),
      sums(std::size_t(halves) * count * planes * 4), samples(std::size_t(halves) * count) {}

std::uint32_t Film::tile_index(std::uint32_t x, std::uint32_t y) const {
    return ((y / TILE) * columns + x / TILE) * TILE * TILE + (y % TILE) * TILE + x % TILE;
}

namespace {

void add_to(double *sums, const float4 *block, std::size_t values) {
    for (std::size_t i = 0; i < values; ++i) {
        sums[4 * i] += block[i].x;
        sums[4 * i + 1] += block[i].y;
        sums[4 * i + 2] += block[i].z;
        sums[4 * i + 3] += block[i].w;
    }
}

/// Value `value` of a pixel's planes.
double sum_of(const double *sums, std::uint32_t value) {
    if (value / 4 != FILM_RADIANCE) return sums[value];
    return whole_sum(sums[value], sums[4 * FILM_REST + value % 4]);
}

} // namespace

void Film::add(const std::vector<float4> &block) { add_to(sums.data(), block.data(), block.size()); }

void Film::add_tile(std::uint32_t tile, std::uint32_t half, const float4 *block, const std::uint32_t *more) {
    const std::size_t first = std::size_t(half) * count + std::size_t(tile) * TILE * TILE;
    add_to(sums.data() + first * planes * 4, block, std::size_t(TILE * TILE) * planes);
    for (std::size_t i = 0; i < TILE * TILE; ++i) samples[first + i] += more[i];
}

void Film::count_samples(std::uint32_t first, std::uint32_t pixel_count, std::uint32_t more) {
    for (std::uint32_t i = first; i < first + pixel_count; ++i) samples[i] += more;
}

std::uint32_t Film::samples_of(std::uint32_t pixel) const {
    std::uint32_t total = 0;
    for (std::size_t half = 0; half < halves; ++half) total += samples[half * count + pixel];
    return total;
}

std::uint64_t Film::total_samples() const {
    std::uint64_t total = 0;
    for (std::uint32_t y = 0; y < crop.height(); ++y)
        for (std::uint32_t x = 0; x < crop.width(); ++x) total += samples_of(tile_index(x, y));
    return total;
}

double Film::mean(std::uint32_t pixel, std::uint32_t value) const {
    double mean = 0, having = 0;
    for (std::size_t half = 0; half < halves; ++half) {
        const std::size_t at = half * count + pixel;
        if (samples[at] == 0) continue;
        mean += sum_of(sums.data() + at * planes * 4, value) * (1.0 / samples[at]);
        having += 1;
    }
    return having > 1 ? mean / having : mean;
}

double Film::ratio(std::uint32_t pixel, std::uint32_t above, std::uint32_t below) const {
    double one = 0, other = 0;
    for (std::size_t half = 0; half < halves; ++half) {
        const std::size_t at = half * count + pixel;
        const double weight = halves > 1 && samples[at] > 0 ? 1.0 / samples[at] : 1;
        one += sums[at * planes * 4 + above] * weight;
        other += sums[at * planes * 4 + below] * weight;
    }
    return other > 0 ? one / other : 0;
}

double Film::variance(std::uint32_t pixel, std::uint32_t channel) const {
    double variance = 0, having = 0;
    for (std::size_t half = 0; half < halves; ++half) {
        const std::size_t at = half * count + pixel;
        const double n = samples[at], *own = sums.data() + at * planes * 4;
        if (n < 1) continue;
        having += 1;
        if (n < 2) continue;
        const double scale = 1 / n, mean = sum_of(own, channel) * scale;
        variance += std::max(0.0, own[4 * FILM_SQUARE + channel] * scale - mean * mean) / (n - 1);
    }
    return having > 1 ? variance / (having * having) : variance;
}

double Film::relative_error() const {
    const double area = double(crop.width()) * crop.height();
    double level = 0, noise = 0;
    for (std::uint32_t pixel = 0; pixel < count; ++pixel)
        for (std::uint32_t c = 0; c < 3; ++c)
            if (const double value = mean(pixel, c); std::isfinite(value)) level += value / (3 * area);
    std::array<MeasuredPixel, TILE * TILE> tile;
    for (std::uint32_t first = 0; first < count; first += TILE * TILE) {
        for (std::uint32_t i = 0; i < TILE * TILE; ++i)
            for (std::uint32_t c = 0; c < 3; ++c) {
                tile[i].mean[c] = mean(first + i, c);
                tile[i].variance[c] = variance(first + i, c);
            }
        noise += relative_noise(tile, noise_floor(level));
    }
    return std::sqrt(noise / area);
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

    const std::uint32_t albedo = 4 * FILM_PLANES, normal = albedo + 4;
    const std::uint32_t orders = 4 * (FILM_PLANES + (layers.surface() ? FILM_SURFACE_PLANES : 0));
    for (std::uint32_t y = 0; y < crop.height(); ++y)
        for (std::uint32_t x = 0; x < crop.width(); ++x) {
            const std::uint32_t pixel = tile_index(x, y);
            const auto put = [&](double value) { picture.pixels.push_back(float(value)); };
            const auto put_means = [&](std::uint32_t first, double scale) {
                for (std::uint32_t c = 0; c < 3; ++c) put(mean(pixel, first + c) * scale);
            };
            put_means(4 * FILM_RADIANCE, unit);
            put(mean(pixel, 4 * FILM_RADIANCE + 3));
            if (layers.albedo) put_means(albedo, 1);
            if (layers.normal) put_means(normal, 1);
            if (layers.depth) put(ratio(pixel, albedo + 3, 4 * FILM_RADIANCE + 3) * length); // of what met geometry
            if (layers.variance)
                for (std::uint32_t c = 0; c < 3; ++c) put(variance(pixel, c) * unit * unit);
            if (layers.samples) put(samples_of(pixel));
            const bool wanted[] = {layers.zero, layers.single, layers.multiple};
            for (std::uint32_t order = 0; order < FILM_SCATTER_PLANES; ++order)
                if (wanted[order]) put_means(orders + 4 * order, unit);
            if (layers.steps) put(ratio(pixel, orders + 7, orders + 3)); // scatters by walks
        }
    return picture;
}

} // namespace nacre::render
