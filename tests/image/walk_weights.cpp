// Walks one after the other: a path that leaves one body for the next is not weighed more from walk to walk.
#include "image/rendered.h"
#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace nacre {
namespace {

/// What balls of this colour give to a channel's share in the draws of hero walks: kernels/walk/walk.h.
constexpr double color[] = {.95, .6, .3}, least_share = .3;

/// A heap of balls of skin in a white sky, one sample a pixel, classical walks: its red, green and blue are what walks
/// have made of 1, 1, 1. Of every pixel their sum, each times what its channel's draws are in proportion to, over that
/// of 1, 1, 1.
std::vector<double> sums(const std::string &sampling, double g) {
    std::string balls;
    for (int i = 0; i < 27; ++i)
        balls += fmt::format(
            R"({}{{"sphere": {{"center": [{}, {}, {}], "radius": 0.55, "segments": 24}}, "material": "skin"}})",
            i ? ", " : "", i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    const io::Picture picture = rendered(scene_of(fmt::format(
                                             R"({{"camera": {{"position": [3, 2, 5], "target": [0, 0, 0], "fov": 30}},
                          "image": {{"width": 96, "height": 96}},
                          "render": {{"spp": 1, "max_depth": 0, "channel_sampling": "{}", "guiding": "none",
                            "control_variate": false}},
                          "materials": {{"skin": {{"subsurface_weight": 1, "subsurface_color": [{}, {}, {}],
                            "subsurface_radius": 0.1, "subsurface_radius_scale": [1, 0.35, 0.2],
                            "subsurface_scatter_anisotropy": {}, "specular_weight": 0}}}},
                          "objects": [{}],
                          "lights": [{{"type": "environment", "radiance": 1, "visible": false}}]}})",
                                             sampling, color[0], color[1], color[2], g, balls)))
                                    .picture;
    double factor[3], all = 0;
    for (int c = 0; c < 3; ++c) all += factor[c] = sampling == "hero" ? color[c] / color[0] + least_share : 1;
    std::vector<double> sums;
    for (std::size_t i = 0; i < picture.pixels.size(); i += picture.channels.size()) {
        double &sum = sums.emplace_back();
        for (std::size_t c = 0; c < 3; ++c) sum += factor[c] / all * double(picture.pixels[i + c]);
    }
    return sums;
}

// Channels are drawn in proportion to what they bring (hero: times what the medium shows), so what all of them bring
// together (times that) never grows: f <= p. Roulette raises no path beyond where it began.
TEST(WalkWeights, DoNotMultiplyFromWalkToWalk) {
    for (const char *sampling : {"single", "throughput", "hero"})
        for (const double g : {0., .8}) {
            const std::vector<double> found = sums(sampling, g);
            EXPECT_LE(std::ranges::max(found), 1.0003) << sampling << ", g " << g;
            EXPECT_GT(std::ranges::count_if(found, [](double sum) { return sum > 0; }), 2000)
                << "it must show the balls";
        }
}

} // namespace
} // namespace nacre
