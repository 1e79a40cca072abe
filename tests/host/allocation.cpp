// Which tiles get more samples, on samples made up here: that deciding by the other half does not bias the picture,
// that deciding by one's own would, and that what is asked for is what is needed.
#include "render/allocation.h"
#include "render/film.h"
#include "render/tile_noise.h"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace nacre::render {
namespace {

using namespace shared;

constexpr std::uint32_t pixels = TILE * TILE, planes = FILM_PLANES;

/// Grey samples: `base`, and now and then `bright`.
struct Source {
    double base = 0.1, bright = 0, chance = 0, cost = 1;
    double mean() const { return base + chance * bright; }

    /// Sums of samples [first, end) of a tile's half: always the same ones.
    std::vector<float4> sums(std::uint32_t seed, std::uint32_t entry, std::uint32_t first, std::uint32_t end) const {
        std::seed_seq words{seed, entry, first};
        std::mt19937 random(words);
        std::binomial_distribution<int> events(int(end - first), chance);
        std::vector<float4> block(pixels * planes);
        for (std::uint32_t i = 0; i < pixels; ++i) {
            const double n = end - first, k = chance > 0 ? events(random) : 0;
            const auto sum = float(n * base + k * bright);
            const auto square = float((n - k) * base * base + k * (base + bright) * (base + bright));
            block[i * planes + FILM_RADIANCE] = {sum, sum, sum, float(n)};
            block[i * planes + FILM_SQUARE] = {square, square, square, float(n * cost)};
        }
        return block;
    }
};

struct Taken {
    double mean = 0;
    std::uint64_t shown = 0, all = 0;
    double converged = 0, error = 0;
    std::vector<float> samples;
};

/// Renders a row of tiles, one for each source. `own`: every half decides for itself, which is what must not be done.
Taken render(const std::vector<Source> &tiles, double target, std::uint32_t most, std::uint32_t seed,
             bool own = false) {
    const Crop crop{0, 0, std::uint32_t(tiles.size()) * TILE, TILE};
    Film film(crop, planes, 2);
    Allocation allocation(crop, planes, target, most);
    Taken taken;
    while (!allocation.list().empty()) {
        std::vector<float4> deciding;
        const std::uint32_t first = allocation.first(), end = allocation.end();
        for (const std::uint32_t entry : allocation.list()) {
            const std::uint32_t tile = entry & ~SECOND_HALF;
            const std::vector<float4> block = tiles[tile].sums(seed, entry, first, end);
            if (allocation.shown(entry))
                film.add_tile(tile, entry & SECOND_HALF ? 1 : 0, block.data(),
                              std::vector<std::uint32_t>(pixels, end - first).data());
            const std::vector<float4> other = tiles[tile].sums(seed, entry ^ SECOND_HALF, first, end);
            deciding.insert(deciding.end(), (own ? other : block).begin(), (own ? other : block).end());
            taken.all += pixels * (end - first);
        }
        allocation.add(deciding);
    }
    Layers layers;
    layers.samples = true;
    const io::Picture picture = film.picture(layers, 1, 1);
    for (std::size_t i = 0; i < picture.pixels.size(); i += picture.channels.size()) {
        taken.mean += picture.pixels[i] / double(pixels * tiles.size());
        taken.samples.push_back(picture.pixels[i + picture.channels.size() - 1]);
    }
    taken.shown = film.total_samples();
    taken.converged = allocation.converged();
    taken.error = film.relative_error();
    return taken;
}

/// How many standard errors the mean over 1,024 pictures of one tile is off.
double bias(const Source &source, double target, bool own) {
    constexpr int seeds = 1024;
    double sum = 0, squares = 0;
    for (int seed = 0; seed < seeds; ++seed) {
        const double off = render({source}, target, 1024, std::uint32_t(seed), own).mean - source.mean();
        sum += off;
        squares += off * off;
    }
    return sum / std::sqrt(std::max(1e-300, squares - sum * sum / seeds));
}

// A third of the halves do not meet the bright paths in the first look.
TEST(Allocation, RareBrightPathsAreNotBiased) {
    const Source source{0.1, 100, 1e-3};
    for (const double target : {0.3, 0.7}) EXPECT_LT(std::abs(bias(source, target, false)), 4) << target;
}

// The same test finds what a half's own decision does: it has power.
TEST(Allocation, OwnDecisionsWouldBias) { EXPECT_LT(bias({0.1, 100, 1e-3}, 0.7, true), -8); }

// A tile alone needs its relative variance over target^2, where its samples are many enough to be normal.
TEST(Allocation, TakesWhatIsNeeded) {
    const Source noisy{0, 1, 0.5}; // variance 1/4, mean 1/2, 1.01 of it squared: .99
    for (const double target : {0.2, 0.1, 0.05}) {
        const Taken taken = render({noisy}, target, 1 << 16, 1);
        const double wanted = std::max(2.0 * FIRST_LOOK, 0.99 / (target * target));
        EXPECT_NEAR(taken.samples[0], wanted, std::max(16.0, 0.3 * wanted)) << target;
        EXPECT_EQ(taken.converged, 1);
        EXPECT_LE(double(taken.all), 1.3 * double(taken.shown) + 1);
    }
}

// Neyman's numbers for tiles of relative variance r: sqrt(r) sum sqrt(r) / (3 target^2).
TEST(Allocation, SamplesGoByTheRootOfRelativeVariance) {
    const Source bright{0, 1, 0.5}, dark{0, 0.01, 0.5}, black{0, 0, 0};
    const Taken taken = render({bright, black, dark}, 0.02, 1 << 16, 1);
    const double floor = noise_floor(0.505 / 3);
    const double of_bright = std::sqrt(0.25 / (0.25 + floor)), of_dark = std::sqrt(0.25e-4 / (0.25e-4 + floor));
    const double each = (of_bright + of_dark) / (3 * 4e-4);
    EXPECT_NEAR(taken.samples[0], each * of_bright,
                0.05 * each * of_bright + 128); // rounded up to blocks of both halves
    EXPECT_NEAR(taken.samples[2 * TILE], each * of_dark, 0.05 * each * of_dark + 128);
    EXPECT_EQ(taken.samples[TILE], 2 * FIRST_LOOK);
}

TEST(Allocation, CostlySamplesAreFewer) {
    const Source dear{0, 1, 0.5, 16}, cheap{0, 1, 0.5, 1};
    const Taken taken = render({dear, dear, cheap, cheap}, 0.01, 1 << 16, 1);
    const double dear_ones = 0.99 / 1e-4 * 0.625,
                 cheap_ones = 4 * dear_ones; // sqrt(r / c) sum sqrt(r c) / (4 target^2)
    EXPECT_NEAR(taken.samples[0], dear_ones, 0.05 * dear_ones + 128);
    EXPECT_NEAR(taken.samples[3 * TILE], cheap_ones, 0.1 * cheap_ones + 128);
    EXPECT_NEAR(taken.error, 0.01, 0.1 * 0.01);
}

// No other way to share out as many samples has a smaller relMSE, and the same number for every pixel a larger one.
TEST(Allocation, TakesFewerThanAnEvenPicture) {
    std::vector<Source> tiles;
    for (int i = 0; i < 64; ++i) tiles.push_back({1, 1, i < 8 ? 0.5 : 1e-3}); // an eighth is noisy
    const Taken taken = render(tiles, 0.005, 1 << 16, 1);
    double relative = 0;
    for (const Source &tile : tiles)
        relative += tile.chance * (1 - tile.chance) / (tile.mean() * tile.mean() + noise_floor(1.0634)) / 64;
    const double even = relative / 2.5e-5 * pixels * 64;
    EXPECT_LT(double(taken.all), 0.5 * even);
    EXPECT_NEAR(taken.error, 0.005, 0.1 * 0.005);
}

TEST(Allocation, QuietTilesAreLeftAtTheFirstLook) {
    const Source quiet{0.5, 0, 0}, noisy{0, 1, 0.5}, black{0, 0, 0};
    const Taken taken = render({quiet, quiet, noisy, black}, 0.02, 4096, 1);
    EXPECT_EQ(taken.samples[0], 2 * FIRST_LOOK);
    EXPECT_GT(taken.samples[TILE], 256) << "beside a noisy one";
    EXPECT_GT(taken.samples[2 * TILE], 512);
    EXPECT_EQ(taken.samples[3 * TILE], 2 * FIRST_LOOK) << "nothing is there";
}

TEST(Allocation, NoMoreThanTheMost) {
    for (const std::uint32_t most : {1u, 2u, 16u, 17u, 100u, 128u}) {
        const Taken taken = render({{0.1, 1, 0.5}, {0, 0, 0}}, 1e-3, most, 1);
        EXPECT_EQ(taken.samples[0], 2 * most);
        EXPECT_EQ(taken.samples[TILE], 2 * std::min(most, FIRST_LOOK));
        if (most > 1) { // one sample has no spread
            EXPECT_EQ(taken.converged, 0.5) << most;
        }
    }
}

} // namespace
} // namespace nacre::render
