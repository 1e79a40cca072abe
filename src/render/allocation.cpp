#include "render/allocation.h"
#include "render/film.h"
#include <algorithm>
#include <cmath>

namespace nacre::render {
namespace {

using namespace shared;

constexpr std::uint32_t tile_pixels = TILE * TILE;

/// Where samples are counted after so many: the film's blocks stay whole.
std::uint32_t step_after(std::uint32_t samples) {
    return samples < FIRST_LOOK ? FIRST_LOOK : FILM_BLOCK - samples % FILM_BLOCK;
}

bool decides_at(std::uint32_t samples) {
    return samples == FIRST_LOOK || (samples >= FILM_BLOCK && (samples & (samples - 1)) == 0);
}

/// Which of the halves an entry of the list is.
std::size_t half_of(std::uint32_t entry) {
    return 2 * std::size_t(entry & ~SECOND_HALF) + (entry & SECOND_HALF ? 1 : 0);
}

/// Sums over the lit pixels of a tile. Dark ones are left out, as they are in the error that a picture is said to have,
/// and those whose sums no float holds: no number of samples makes them better.
struct Lit {
    double mean = 0, variance = 0, count = 0; // over pixels and channels; variance: of one sample
    Lit &operator+=(const Lit &more) {
        mean += more.mean;
        variance += more.variance;
        count += more.count;
        return *this;
    }
};

Lit lit_of(const std::array<double, 4> *pixels, double n) {
    Lit lit;
    for (std::uint32_t i = 0; i < tile_pixels; ++i) {
        const auto &[r, g, b, squares] = pixels[i];
        if (!(r + g + b > 0) || !std::isfinite(r + g + b + squares)) continue;
        lit.count += 3;
        lit.mean += (r + g + b) / n;
        if (n > 1) lit.variance += std::max(0.0, squares - (r * r + g * g + b * b) / n) / (n - 1);
    }
    return lit;
}

/// Samples of each half with which the mean square error of a tile's pixels is target^2 x its mean x the picture's.
/// That is the same noise everywhere on a display, which shows about the square root of radiance, and that of the
/// picture, the root of its mean variance over its mean, becomes `target`.
double relative_need(const Lit &lit, double level, double target) {
    const double allowed = target * target * lit.mean * level; // of the sum of variances, over the lit pixels
    return allowed > 0 ? lit.variance / (2 * allowed) : 0;
}

} // namespace

Allocation::Allocation(const Crop &crop, std::uint32_t planes, double target, std::uint32_t most)
    : planes(planes), most(most), columns((crop.width() + TILE - 1) / TILE), rows((crop.height() + TILE - 1) / TILE),
      target(target) {
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
        std::array<double, 4> *pixels = sums.data() + half_of(entries[i]) * tile_pixels;
        for (std::size_t pixel = 0; pixel < tile_pixels; ++pixel) {
            const float4 *from = film.data() + (i * tile_pixels + pixel) * planes;
            auto &[r, g, b, squares] = pixels[pixel];
            const float4 &sum = from[FILM_RADIANCE], &rest = from[FILM_REST];
            r += whole_sum(sum.x, rest.x);
            g += whole_sum(sum.y, rest.y);
            b += whole_sum(sum.z, rest.z);
            squares += double(from[FILM_SQUARE].x) + from[FILM_SQUARE].y + from[FILM_SQUARE].z;
        }
    }
    taken = end();
    for (const std::uint32_t deciding : {0u, 1u}) {
        if (taken == std::min(FIRST_LOOK, most)) first_look(deciding);
        if (decides_at(taken) || taken == most) look(deciding);
    }
    begin();
}

void Allocation::first_look(std::uint32_t deciding) {
    std::vector<Lit> tiles(halves.size() / 2);
    Lit picture;
    for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
        tiles[tile] = lit_of(sums.data() + (2 * tile + deciding) * tile_pixels, taken);
        picture += tiles[tile];
    }
    if (picture.count > 0) level[deciding] = picture.mean / picture.count;
    for (std::uint32_t tile = 0; tile < tiles.size(); ++tile) {
        if (tiles[tile].count == 0) continue;
        Lit around;
        const std::uint32_t x = tile % columns, y = tile / columns;
        for (std::uint32_t v = y - (y > 0); v <= std::min(y + 1, rows - 1); ++v)
            for (std::uint32_t u = x - (x > 0); u <= std::min(x + 1, columns - 1); ++u)
                around += tiles[v * columns + u];
        halves[2 * tile + (deciding ^ 1)].least = relative_need(around, level[deciding], target);
    }
}

void Allocation::look(std::uint32_t deciding) {
    const std::uint32_t next = taken == FIRST_LOOK ? taken : 2 * taken;
    for (std::size_t i = deciding; i < halves.size(); i += 2) {
        Half &other = halves[i ^ 1];
        if (other.final > 0) continue;
        const double need = relative_need(lit_of(sums.data() + i * tile_pixels, taken), level[deciding], target);
        other.need = std::max(need, other.least);
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
