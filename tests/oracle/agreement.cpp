#include "oracle/agreement.h"
#include "base/error.h"
#include <algorithm>
#include <cmath>

namespace nacre::reference {
namespace {

constexpr int tile = 4;

/// A sum of differences and its variance.
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

/// The variances of a channel, none below the mean of those up to two pixels away: where light comes by rare large
/// samples a pixel that had none of them believes itself far too exact.
std::vector<double> pooled(const std::vector<double> &own, int width, int height) {
    std::vector<double> result = own;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double sum = 0, count = 0;
            for (int j = std::max(0, y - 2); j <= std::min(height - 1, y + 2); ++j)
                for (int i = std::max(0, x - 2); i <= std::min(width - 1, x + 2); ++i, ++count)
                    sum += own[std::size_t(j * width + i)];
            double &value = result[std::size_t(y * width + x)];
            value = std::max(value, sum / count);
        }
    return result;
}

/// One channel of two pictures.
struct Channel {
    std::vector<double> found, expected;
    std::vector<double> variance, safe_variance; // of the difference; the second pooled
};

Channel channel_of(const io::Picture &picture, const Image &reference, std::size_t c) {
    Channel channel;
    std::vector<double> mine, theirs;
    const std::size_t variance = layer(picture, "variance.R"), channels = picture.channels.size();
    for (std::size_t pixel = 0; pixel < reference.mean.size() / 3; ++pixel) {
        channel.found.push_back(picture.pixels[pixel * channels + c]);
        channel.expected.push_back(reference.mean[3 * pixel + c]);
        mine.push_back(picture.pixels[pixel * channels + variance + c]);
        theirs.push_back(reference.variance[3 * pixel + c] + std::pow(2e-6 * channel.expected.back(), 2));
    }
    const std::vector<double> my_pool = pooled(mine, reference.width, reference.height);
    const std::vector<double> their_pool = pooled(theirs, reference.width, reference.height);
    for (std::size_t pixel = 0; pixel < mine.size(); ++pixel) {
        channel.variance.push_back(mine[pixel] + theirs[pixel]);
        channel.safe_variance.push_back(my_pool[pixel] + their_pool[pixel]);
    }
    return channel;
}

} // namespace

Agreement compare(const io::Picture &picture, const Image &reference) {
    Agreement result;
    Sum all;
    const int width = reference.width, height = reference.height, columns = (width + tile - 1) / tile;
    for (std::size_t c = 0; c < 3; ++c) {
        const Channel channel = channel_of(picture, reference, c);
        std::vector<Sum> tiles(std::size_t(columns * ((height + tile - 1) / tile)));
        Sum whole;
        double total = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const std::size_t at = std::size_t(y * width + x);
                const double difference = channel.found[at] - channel.expected[at];
                Sum pixel;
                pixel.add(difference, channel.safe_variance[at]);
                tiles[std::size_t(y / tile * columns + x / tile)].add(difference, channel.safe_variance[at]);
                whole.add(difference, channel.variance[at]);
                total += channel.expected[at];
                if (pixel.deviations() <= result.pixel) continue;
                result.pixel = pixel.deviations();
                result.x = x;
                result.y = y;
                result.channel = int(c);
            }
        for (const Sum &sum : tiles) result.tile = std::max(result.tile, sum.deviations());
        all.add(whole.difference, whole.variance);
        result.whole[c] = whole.deviations();
        result.difference[c] = whole.difference / total;
        result.error[c] = std::sqrt(whole.variance) / total;
    }
    result.all = all.deviations();
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
