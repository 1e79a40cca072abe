#include "render/allocation.h"
#include "render/film.h"
#include "render/tile_noise.h"
#include <algorithm>
#include <cmath>

namespace nacre::render {
namespace {

using namespace shared;

constexpr std::uint32_t tile_pixels = TILE * TILE;

/// Where samples are counted after so many: the film's blocks stay whole, and few samples are not rounded up to many.
std::uint32_t step_after(std::uint32_t samples) {
    const std::uint32_t block = samples < 2 * FILM_BLOCK ? FIRST_LOOK : FILM_BLOCK;
    return block - samples % block;
}

bool decides_at(std::uint32_t samples) { return samples >= FIRST_LOOK && (samples & (samples - 1)) == 0; }

/// Which of the halves an entry of the list is.
std::size_t half_of(std::uint32_t entry) {
    return 2 * std::size_t(entry & ~SECOND_HALF) + (entry & SECOND_HALF ? 1 : 0);
}

} // namespace

Allocation::Allocation(const Crop &crop, std::uint32_t planes, double target, std::uint32_t most)
    : planes(planes), most(most), width(crop.width()), height(crop.height()), columns((width + TILE - 1) / TILE),
      rows((height + TILE - 1) / TILE), target(target) {
    halves.resize(2 * std::size_t(columns) * rows);
    sums.resize(halves.size() * tile_pixels);
    begin();
}

std::uint32_t Allocation::end() const { return std::min(most, taken + step_after(taken)); }

bool Allocation::shown(std::uint32_t entry) const {
    const Half &half = halves[half_of(entry)];
    return half.final == 0 || taken < half.final;
}

void Allocation::begin() {
    entries.clear();
    for (std::uint32_t i = 0; i < halves.size() && taken < most; ++i)
        if (halves[i].final == 0 || taken < halves[i].final || halves[i ^ 1].final == 0)
            entries.push_back(i / 2 | (i % 2 ? SECOND_HALF : 0u));
}

void Allocation::add(const std::vector<float4> &film) {
    for (std::size_t i = 0; i < entries.size(); ++i) {
        std::array<double, 7> *pixels = sums.data() + half_of(entries[i]) * tile_pixels;
        for (std::size_t pixel = 0; pixel < tile_pixels; ++pixel) {
            const float4 *from = film.data() + (i * tile_pixels + pixel) * planes;
            const float4 &sum = from[FILM_RADIANCE], &rest = from[FILM_REST], &square = from[FILM_SQUARE];
            const double more[] = {whole_sum(sum.x, rest.x),
                                   whole_sum(sum.y, rest.y),
                                   whole_sum(sum.z, rest.z),
                                   square.x,
                                   square.y,
                                   square.z,
                                   square.w};
            for (std::size_t k = 0; k < 7; ++k) pixels[pixel][k] += more[k];
        }
    }
    taken = end();
    for (const std::uint32_t deciding : {0u, 1u}) {
        if (taken == std::min(FIRST_LOOK, most)) first_look(deciding);
        if (decides_at(taken) || taken == most) look(deciding);
    }
    begin();
}

/// Of a tile's pixels, those in the picture.
double Allocation::inside(std::size_t tile) const {
    const std::uint32_t x = std::uint32_t(tile) % columns * TILE, y = std::uint32_t(tile) / columns * TILE;
    return double(std::min<std::uint32_t>(TILE, width - x)) * std::min<std::uint32_t>(TILE, height - y);
}

double Allocation::noise_of(std::size_t half) const {
    std::array<MeasuredPixel, tile_pixels> tile;
    const double n = taken;
    for (std::size_t pixel = 0; pixel < tile_pixels; ++pixel) {
        const std::array<double, 7> &sum = sums[half * tile_pixels + pixel];
        for (std::size_t c = 0; c < 3; ++c) {
            const double mean = sum[c] / n;
            tile[pixel].mean[c] = mean;
            tile[pixel].variance[c] = n > 1 ? std::max(0.0, sum[3 + c] / n - mean * mean) / (n - 1) : 0;
        }
    }
    return n * relative_noise(tile, floor[half % 2]) / inside(half / 2);
}

double Allocation::cost_of(std::size_t half) const {
    double sum = 0;
    for (std::size_t pixel = 0; pixel < tile_pixels; ++pixel) sum += sums[half * tile_pixels + pixel][6];
    return std::max(1.0, sum / (inside(half / 2) * taken));
}

void Allocation::first_look(std::uint32_t deciding) {
    const std::size_t tiles = halves.size() / 2;
    std::vector<double> light(tiles);
    double level = 0;
    for (std::size_t tile = 0; tile < tiles; ++tile) {
        for (std::size_t i = 0; i < tile_pixels; ++i) {
            const std::array<double, 7> &sum = sums[(2 * tile + deciding) * tile_pixels + i];
            if (const double all = sum[0] + sum[1] + sum[2]; std::isfinite(all)) light[tile] += all / taken;
        }
        level += light[tile] / (3.0 * width * height);
    }
    floor[deciding] = noise_floor(level);
    std::vector<double> noise(tiles);
    for (std::size_t tile = 0; tile < tiles; ++tile) noise[tile] = noise_of(2 * tile + deciding);
    for (std::uint32_t tile = 0; tile < tiles; ++tile) {
        if (!(light[tile] > 0)) continue; // nothing is there
        double sum = 0, pixels = 0;
        const std::uint32_t x = tile % columns, y = tile / columns;
        for (std::uint32_t v = y - (y > 0); v <= std::min(y + 1, rows - 1); ++v)
            for (std::uint32_t u = x - (x > 0); u <= std::min(x + 1, columns - 1); ++u) {
                const double there = inside(v * columns + u);
                sum += there * noise[v * columns + u];
                pixels += there;
            }
        halves[2 * tile + deciding].around = sum / pixels;
    }
}

double Allocation::Half::worth() const { return std::sqrt(std::max(noise, around) / cost); }

/// Samples of a half, for each unit of worth, with which the relMSE is the target's square. What has more than that
/// already, and is that much better, is not asked for elsewhere again.
double Allocation::samples_per_worth(std::uint32_t deciding) const {
    double result = 0;
    // With every turn fewer samples and so more tiles that have enough: 20 are more than it takes.
    for (int turn = 0; turn < 20; ++turn) {
        double asked = 0, left = target * target * width * height;
        for (std::size_t i = deciding; i < halves.size(); i += 2) {
            const Half &half = halves[i], &other = halves[i ^ 1];
            const double worth = half.worth(), weight = inside(i / 2) * half.noise / 2; // of two halves
            const double has = other.final > 0 ? other.final : taken;
            if (worth > 0 && (turn == 0 || result * worth > has))
                asked += weight / worth;
            else
                left -= weight / has;
        }
        if (turn > 0 && (asked == 0 || asked / left >= result)) break;
        result = asked / left;
    }
    return result;
}

void Allocation::look(std::uint32_t deciding) {
    const std::uint32_t next = taken == FIRST_LOOK ? taken : 2 * taken;
    for (std::size_t i = deciding; i < halves.size(); i += 2)
        if (halves[i ^ 1].final == 0) {
            halves[i].noise = noise_of(i);
            halves[i].cost = cost_of(i);
        }
    const double each = samples_per_worth(deciding);
    for (std::size_t i = deciding; i < halves.size(); i += 2) {
        Half &other = halves[i ^ 1];
        if (other.final > 0) continue;
        other.need = each * halves[i].worth();
        if (other.need > next && next < most) continue;
        std::uint32_t final = taken; // fewer than it has make no sense
        while (final < other.need && final < most) final = std::min(most, final + step_after(final));
        other.final = final;
    }
}

std::uint64_t Allocation::expected() const {
    double total = 0;
    for (std::size_t i = 0; i < halves.size(); ++i) {
        const Half &own = halves[i], &other = halves[i ^ 1];
        const double given = own.final > 0 ? own.final : own.need, asked = other.final > 0 ? 0 : other.need;
        total += std::min(double(most), std::max({given, asked, double(end())}));
    }
    return std::uint64_t(total) * tile_pixels;
}

double Allocation::converged() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < halves.size(); i += 2)
        count += halves[i].final > 0 && halves[i + 1].final > 0 && halves[i].need <= most && halves[i + 1].need <= most;
    return double(count) / double(halves.size() / 2);
}

} // namespace nacre::render
