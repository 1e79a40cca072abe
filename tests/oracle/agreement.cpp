#include "oracle/agreement.h"
#include "base/error.h"
#include <algorithm>
#include <cmath>

namespace nacre::reference {
namespace {

constexpr int tile = 4;

/// A sum of differences and the variance of it.
struct Sum {
    double difference = 0, variance = 0;

    void add(double value, double spread) {
        difference += value;
        variance += spread;
    }
    double deviations() const { return variance > 0 ? std::abs(difference) / std::sqrt(variance) : 0; }
};

std::size_t layer(const io::Picture &picture, const std::string &name) {
    const auto found = std::find(picture.channels.begin(), picture.channels.end(), name);
    if (found == picture.channels.end()) throw Error(Exit::failed, "picture", "has no layer " + name);
    return std::size_t(found - picture.channels.begin());
}

} // namespace

Agreement compare(const io::Picture &picture, const Image &reference) {
    Agreement result;
    const std::size_t variance = layer(picture, "variance.R"), channels = picture.channels.size();
    const int columns = (picture.width + tile - 1) / tile, rows = (picture.height + tile - 1) / tile;
    for (int c = 0; c < 3; ++c) {
        std::vector<Sum> tiles(std::size_t(columns * rows));
        Sum whole;
        double total = 0;
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) {
                const std::size_t at = std::size_t(y * picture.width + x);
                const float *found = &picture.pixels[at * channels];
                const double expected = reference.mean[3 * at + std::size_t(c)];
                Sum pixel;
                pixel.add(found[c] - expected, found[variance + std::size_t(c)] +
                                                   reference.variance[3 * at + std::size_t(c)] +
                                                   std::pow(2e-6 * expected, 2));
                tiles[std::size_t(y / tile * columns + x / tile)].add(pixel.difference, pixel.variance);
                whole.add(pixel.difference, pixel.variance);
                total += expected;
                if (pixel.deviations() <= result.pixel) continue;
                result.pixel = pixel.deviations();
                result.x = x;
                result.y = y;
                result.channel = c;
            }
        for (const Sum &sum : tiles) result.tile = std::max(result.tile, sum.deviations());
        result.whole[std::size_t(c)] = whole.deviations();
        result.difference[std::size_t(c)] = whole.difference / total;
        result.error[std::size_t(c)] = std::sqrt(whole.variance) / total;
    }
    return result;
}

double largest_deviation(std::size_t count) {
    const double each = -std::expm1(std::log1p(-1e-4) / double(count)); // two-sided
    double low = 0, high = 40;
    for (int i = 0; i < 100; ++i) {
        const double middle = (low + high) / 2;
        (std::erfc(middle / std::sqrt(2)) > each ? low : high) = middle;
    }
    return high;
}

} // namespace nacre::reference
