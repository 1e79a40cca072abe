#include "compare/estimate.h"
#include "base/error.h"
#include <algorithm>
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

std::string window(const io::Picture &picture) {
    return fmt::format("{} x {} pixels at {}, {}", picture.width, picture.height, picture.crop_x, picture.crop_y);
}

} // namespace

Estimate estimate_of(const io::Picture &picture, const std::string &name) {
    Estimate estimate;
    estimate.width = picture.width;
    estimate.height = picture.height;
    estimate.mean = colors(picture, "");
    if (estimate.mean.empty()) input_error(name, "has no channels R, G and B: compare pictures of colour");
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
