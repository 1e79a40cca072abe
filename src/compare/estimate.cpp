#include "compare/estimate.h"
#include "base/error.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace nacre::compare {
namespace {

std::optional<std::size_t> channel_of(const io::Picture &picture, const std::string &name) {
    const auto found = std::find(picture.channels.begin(), picture.channels.end(), name);
    if (found == picture.channels.end()) return {};
    return std::size_t(found - picture.channels.begin());
}

/// Three channels of every pixel; nothing where one of them is missing.
std::vector<std::array<float, 3>> colors(const io::Picture &picture, const std::string &prefix) {
    std::array<std::size_t, 3> from{};
    for (std::size_t c = 0; c < 3; ++c) {
        const auto found = channel_of(picture, prefix + "RGB"[c]);
        if (!found) return {};
        from[c] = *found;
    }
    const std::size_t channels = picture.channels.size();
    std::vector<std::array<float, 3>> values(picture.pixels.size() / channels);
    for (std::size_t i = 0; i < values.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) values[i][c] = picture.pixels[i * channels + from[c]];
    return values;
}

double level_of(const std::vector<std::array<float, 3>> &colors) {
    double sum = 0, count = 0;
    for (const auto &color : colors)
        for (const float value : color)
            if (std::isfinite(value)) {
                sum += std::abs(value);
                ++count;
            }
    return count > 0 ? sum / count : 0;
}

std::string window(const io::Picture &picture) {
    return fmt::format("{} x {} pixels at {}, {}", picture.width, picture.height, picture.crop_x, picture.crop_y);
}

} // namespace

// A film adds up blocks of 64 samples in float, each addition good to 2^-24 of the sum, before it goes on in double.
// Far below the picture's level the squares of samples are below what floats hold, and so is their variance: what is
// there counts as nothing. The layer itself is float too, and good to the smallest of them.
Measured Estimate::at(std::size_t pixel, int channel) const {
    const auto c = std::size_t(channel);
    const double value = mean[pixel][c];
    return {value, double(variance[pixel][c]) + std::numeric_limits<float>::min(), samples[pixel],
            64 * 0x1p-24 * std::abs(value) + 1e-10 * level};
}

Estimate estimate_of(const io::Picture &picture, const std::string &name) {
    Estimate estimate;
    estimate.width = picture.width;
    estimate.height = picture.height;
    estimate.mean = colors(picture, "");
    if (estimate.mean.empty()) input_error(name, "has no channels R, G and B: compare pictures of colour");
    estimate.level = level_of(estimate.mean);
    estimate.variance = colors(picture, "variance.");
    if (const auto samples = channel_of(picture, "samples")) {
        const std::size_t channels = picture.channels.size();
        estimate.samples.reserve(estimate.mean.size());
        for (std::size_t i = *samples; i < picture.pixels.size(); i += channels)
            estimate.samples.push_back(picture.pixels[i]);
    }
    return estimate;
}

void check_same_window(const io::Picture &a, const std::string &name_a, const io::Picture &b,
                       const std::string &name_b) {
    const std::string first = window(a), second = window(b);
    if (first != second)
        input_error(name_b, "is {}, {} is {}: compare pictures of the same size and crop", second, name_a, first);
}

} // namespace nacre::compare
