// Adaptive renders: not biased by their stopping, the same whatever the launches, as good as was asked for, and quiet
// tiles left out.
#include "image/light_scene.h"
#include "shared/path.h"
#include <algorithm>
#include <atomic>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace nacre {
namespace {

render::Options adaptive(double error) {
    render::Options options;
    options.error = error;
    options.layers.variance = options.layers.samples = true;
    return options;
}

std::size_t channel(const io::Picture &picture, const std::string &name) {
    return std::size_t(std::find(picture.channels.begin(), picture.channels.end(), name) - picture.channels.begin());
}

std::vector<float> samples_of(const io::Picture &picture) {
    std::vector<float> samples;
    for (std::size_t i = channel(picture, "samples"); i < picture.pixels.size(); i += picture.channels.size())
        samples.push_back(picture.pixels[i]);
    return samples;
}

/// A ball of wax in a white sky that is not seen; half of the picture is empty.
scene::Scene ball(int size, std::uint32_t spp, std::uint32_t seed = 1) {
    scene::Scene scene = scene_of(fmt::format(R"({{
        "camera": {{"position": [0, 0, 5], "target": [0, 0, 0], "fov": 40}},
        "image": {{"width": {0}, "height": {0}}},
        "materials": {{"wax": {{"subsurface_weight": 1, "subsurface_albedo": 0.9, "subsurface_radius": 0.1,
            "specular_weight": 0}}}},
        "objects": [{{"sphere": {{"segments": 48}}, "material": "wax"}}],
        "lights": [{{"type": "environment", "visible": false}}]}})",
                                              size));
    scene.render.spp = spp;
    scene.render.seed = seed;
    return scene;
}

// 256 cells of 3 x 3 tiles, in the middle of each a lamp that covers a thousandth of its tile and brings half of its
// light, before a dim sky. They know nothing of each other, so that this is as good as 256 seeds of one; a third of the
// halves do not meet the lamp in the first look. With halves[i ^ 1] in allocation.cpp made halves[i], own decisions,
// the mean is ten errors too dark.
TEST(Adaptive, RareBrightPathsAreNotBiased) {
    constexpr int cells = 16, cell = 3;
    const double side = std::sqrt(1e-3), sky = 0.1, lamp = 100;
    scene::Mesh lamps;
    for (int y = 0; y < cells; ++y)
        for (int x = 0; x < cells; ++x) {
            // Anywhere in its tile: the golden ratio's and another sequence.
            const double u = std::fmod(0.618034 * (cells * y + x), 1), v = std::fmod(0.754878 * (cells * y + x), 1);
            const Vec3 corner(cell * (x - cells / 2) + 1 + (1 - side) * u, cell * (y - cells / 2) + 1 + (1 - side) * v,
                              0);
            const scene::Mesh one = quad(corner, {side, 0, 0}, {0, side, 0});
            const auto first = std::uint32_t(lamps.positions.size());
            lamps.positions.insert(lamps.positions.end(), one.positions.begin(), one.positions.end());
            lamps.uvs.insert(lamps.uvs.end(), one.uvs.begin(), one.uvs.end());
            for (const auto &t : one.triangles) lamps.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
        }
    scene::Scene scene = floor_scene(0);
    scene.objects.clear();
    add_emitter(scene, lamps, {lamp, lamp, lamp});
    scene.lights.push_back(constant_sky({sky, sky, sky}));
    scene.camera.position = {0, 0, 5};
    scene.camera.height = cells * cell;
    scene.image.width = scene.image.height = cells * cell * TILE;
    scene.render.spp = 4096;
    scene.render.max_depth = 1;
    const Rendered picture = rendered(scene, adaptive(0.015));

    double sum = 0, squares = 0;
    for (int cy = 1; cy < cells * cell; cy += cell)
        for (int cx = 1; cx < cells * cell; cx += cell) {
            double tile = 0;
            for (int y = 0; y < TILE; ++y)
                for (int x = 0; x < TILE; ++x) tile += picture.at(cx * TILE + x, cy * TILE + y, 0) / (TILE * TILE);
            sum += tile;
            squares += tile * tile;
        }
    const double count = cells * cells, mean = sum / count;
    const double error = std::sqrt((squares / count - mean * mean) / (count - 1));
    const double exact = sky * (1 - 1e-3) + lamp * 1e-3;
    EXPECT_LT(error, 0.03 * exact);
    EXPECT_LT(std::abs(mean - exact), 4 * error) << mean << " is " << (mean - exact) / error << " errors off " << exact;
    const std::vector<float> samples = samples_of(picture.picture);
    int early = 0; // tiles with a lamp of which both halves missed it, or one
    for (std::size_t y = TILE; y < std::size_t(scene.image.height); y += cell * TILE)
        for (std::size_t x = TILE; x < std::size_t(scene.image.width); x += cell * TILE)
            early += samples[y * std::size_t(scene.image.width) + x] < 300;
    EXPECT_GT(early, 8) << "nothing to see here";
    EXPECT_LT(early, 236);
}

// One path per work-item, lanes of any width, the generic kernel: the same decisions and the same picture, to the bit.
TEST(Adaptive, LaunchesDoNotShow) {
    scene::Scene scene = ball(48, 512);
    const Rendered picture = rendered(scene, adaptive(0.03));
    const std::vector<float> samples = samples_of(picture.picture);
    ASSERT_GT(*std::max_element(samples.begin(), samples.end()), 64);
    for (const int lanes : lane_counts()) {
        SCOPED_TRACE(lanes);
        scene.lanes = lanes;
        expect_same_pixels(picture.picture, rendered(scene, adaptive(0.03)).picture);
    }
    scene.lanes = 0;
    render::Options generic = adaptive(0.03);
    generic.generic = true;
    expect_same_pixels(picture.picture, rendered(scene, generic).picture);
}

// The true error, from the spread of 8 seeds, is what was asked for, and what each render says it reached. Sobol
// samples are more even than their own spread says, which makes it smaller.
TEST(Adaptive, ErrorIsWhatWasAskedFor) {
    constexpr int seeds = 8, size = 48;
    constexpr double target = 0.04;
    std::vector<double> sum(size * size * 3), squares(sum.size());
    for (int seed = 0; seed < seeds; ++seed) {
        const Rendered one = rendered(ball(size, 1 << 16, std::uint32_t(seed)), adaptive(target));
        EXPECT_EQ(one.statistics.adaptive->converged, 1);
        EXPECT_NEAR(one.statistics.adaptive->reached, target, 0.15 * target);
        for (std::size_t i = 0; i < sum.size(); ++i) {
            const double value = one.picture.pixels[i / 3 * one.picture.channels.size() + i % 3];
            sum[i] += value;
            squares[i] += value * value;
        }
    }
    double level = 0, relative = 0;
    for (const double value : sum) level += value / seeds / double(sum.size());
    for (std::size_t i = 0; i < sum.size(); ++i) {
        const double mean = sum[i] / seeds, variance = (squares[i] - sum[i] * mean) / (seeds - 1);
        relative += variance / (mean * mean + 0.01 * level * level) / double(sum.size());
    }
    const double error = std::sqrt(relative);
    ::testing::Test::RecordProperty("error", fmt::format("{}", error));
    EXPECT_LT(error, 1.1 * target);
    EXPECT_GT(error, 0.6 * target);
}

TEST(Adaptive, QuietTilesAreSkippedAndCounted) {
    const Rendered picture = rendered(ball(64, 1024), adaptive(0.02));
    const std::vector<float> samples = samples_of(picture.picture);
    EXPECT_EQ(samples[0], 32) << "an empty corner";
    EXPECT_GT(samples[32 * 64 + 32], 128) << "the ball";
    double shown = 0;
    for (const float n : samples) shown += n;
    const auto &done = *picture.statistics.adaptive;
    EXPECT_EQ(double(done.shown), shown);
    EXPECT_GE(picture.statistics.samples, done.shown);
    EXPECT_LT(double(picture.statistics.samples), 1.5 * shown) << "much is thrown away";
}

TEST(Adaptive, NoMoreSamplesThanAllowed) {
    const Rendered picture = rendered(ball(32, 101), adaptive(1e-4));
    const std::vector<float> samples = samples_of(picture.picture);
    EXPECT_EQ(*std::max_element(samples.begin(), samples.end()), 100);
    EXPECT_LT(picture.statistics.adaptive->converged, 1);
    EXPECT_NE(picture.statistics.remarks().front().find("did not come to"), std::string::npos);
}

// A crop whose tiles stick out over its edges.
TEST(Adaptive, CropsOfAnySize) {
    render::Options options = adaptive(0.05);
    options.crop = {11, 13, 40, 38};
    const Rendered part = rendered(ball(48, 1 << 16), options);
    EXPECT_EQ(part.picture.pixels.size(), 29 * 25 * part.picture.channels.size());
    const std::vector<float> samples = samples_of(part.picture);
    EXPECT_GE(*std::min_element(samples.begin(), samples.end()), 32);
    EXPECT_EQ(part.statistics.adaptive->converged, 1);
}

// Time ends a render of either kind; the picture is of what there is, and every pixel's count is true.
TEST(Adaptive, TimeEndsIt) {
    for (const double error : {0.0, 1e-4}) {
        render::Options options = adaptive(error);
        options.seconds = 0.3;
        const scene::Scene scene = ball(64, 1 << 20);
        render::Session session(device::open_device(), scene, options);
        EXPECT_TRUE(session.render(scene.render.spp));
        const render::Statistics statistics = session.statistics();
        EXPECT_GE(statistics.sampling, 0.3);
        EXPECT_LT(statistics.sampling, 3); // launches are of 0.1 s
        double total = 0;
        for (const float n : samples_of(session.picture())) total += n;
        EXPECT_GT(total, 0);
        EXPECT_EQ(total, double(error > 0 ? statistics.adaptive->shown : statistics.samples));
    }
}

} // namespace
} // namespace nacre
