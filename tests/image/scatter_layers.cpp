// The layers of scattering orders: what they add up to, what they are where that is known, and that they change nothing
// else.
#include "image/box_scene.h"
#include "image/light_scene.h"
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>

namespace nacre {
namespace {

const render::Layers orders{.zero = true, .single = true, .multiple = true, .steps = true};

// Channels of such a picture.
enum : std::size_t { root = 0, alpha = 3, zero = 4, single = 7, multiple = 10, steps = 13, channels = 14 };

Rendered with(const scene::Scene &scene, const render::Layers &layers = orders) {
    render::Options options;
    options.layers = layers;
    return rendered(scene, options);
}

/// Mean over the pixels that geometry covers.
Mean mean_of(const Rendered &image, std::size_t channel) {
    double sum = 0, squares = 0, count = 0;
    for (std::size_t i = 0; i < image.picture.pixels.size(); i += channels) {
        if (image.picture.pixels[i + alpha] != 1) continue;
        const double value = image.picture.pixels[i + channel];
        sum += value;
        squares += value * value;
        ++count;
    }
    return {sum / count, std::sqrt(std::max(0.0, squares / count - sum * sum / (count * count)) / (count - 1))};
}

void expect_mean(const Rendered &image, std::size_t channel, double exact, double largest_error) {
    const Mean found = mean_of(image, channel);
    EXPECT_NEAR(found.value, exact, 4 * found.error);
    EXPECT_LE(found.error, largest_error);
}

// Two bodies that light each other, thin and dense; past the first block of samples.
TEST(ScatterLayers, AddUpToTheWhole) {
    const scene::Scene scene = scene_of(R"({
        "camera": {"position": [0, 1, 5], "fov": 35}, "image": {"width": 48, "height": 32}, "render": {"spp": 70, "max_depth": 0},
        "materials": {
          "jade": {"subsurface_weight": 1, "subsurface_color": [0.5, 0.8, 0.6], "subsurface_radius": 0.9,
                   "subsurface_radius_scale": [1, 0.7, 0.4], "specular_weight": 0},
          "wax": {"subsurface_weight": 1, "subsurface_color": [0.9, 0.7, 0.5], "subsurface_radius": 0.1,
                  "subsurface_bleed": 0.5, "specular_weight": 0}},
        "objects": [{"sphere": {"center": [-1.05, 0, 0], "segments": 32}, "material": "jade"},
                    {"sphere": {"center": [1.05, 0, 0], "segments": 32}, "material": "wax"}],
        "lights": [{"type": "environment", "radiance": [0.3, 0.4, 0.5], "visible": false},
                   {"type": "rect", "center": [0, 4, 0], "u": [2, 0, 0], "v": [0, 0, 2], "radiance": 5},
                   {"type": "point", "position": [0, 0, 3], "intensity": 4}]})");
    const Rendered image = with(scene);
    double total[3] = {};
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 48; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                const double whole = image.at(x, y, root + c);
                const double parts[] = {image.at(x, y, zero + c), image.at(x, y, single + c),
                                        image.at(x, y, multiple + c)};
                ASSERT_NEAR(parts[0] + parts[1] + parts[2], whole, 1e-5 * whole) << x << ", " << y;
                for (int order = 0; order < 3; ++order) total[order] += parts[order];
            }
    for (const double light : total) EXPECT_GT(light, .05 * (total[0] + total[1] + total[2])) << "an order has nothing";
}

// A ball that absorbs nothing, entered with Lambert's cosine, in white light: its chords are 2 tau cos(theta) long, and
// mean paths are 4 V / S (Blanco and Fournier 2003), whatever the phase function.
TEST(ScatterLayers, SphereIsExact) {
    for (const double tau : {.5, 2.})
        for (const double g : {0., .8}) {
            SCOPED_TRACE(testing::Message() << "tau " << tau << " g " << g);
            Medium medium;
            medium.g = g;
            scene::Scene scene = ball(medium, tau);
            scene.render.spp = 64;
            const Rendered image = with(scene);
            const double never = (1 - (1 + 2 * tau) * std::exp(-2 * tau)) / (2 * tau * tau);
            expect_mean(image, zero, never, 2e-3);
            expect_mean(image, steps, 4 * tau / 3, 1e-2);
            const Mean once = mean_of(image, single), more = mean_of(image, multiple);
            EXPECT_NEAR(once.value + more.value, 1 - never, 4 * std::hypot(once.error, more.error));
        }
}

// A quarter goes below the surface, the rest is Lambert's and in no layer.
TEST(ScatterLayers, LeaveOutWhatNeverWalked) {
    scene::Scene scene = ball({}, 1);
    for (scene::Material &material : scene.materials) {
        material[shared::PARAMETER_subsurface_weight].value = Vec3::Constant(.25);
        material[shared::PARAMETER_base_color].value = Vec3::Constant(1);
    }
    scene.render.spp = 64;
    const Rendered image = with(scene);
    const Mean parts[] = {mean_of(image, zero), mean_of(image, single), mean_of(image, multiple)};
    EXPECT_NEAR(parts[0].value + parts[1].value + parts[2].value, .25, 2e-3);
    expect_mean(image, steps, 4. / 3, 2e-2);

    const Rendered none = with(floor_scene());
    for (std::size_t i = 0; i < none.picture.pixels.size(); ++i)
        if (i % channels >= zero) {
            ASSERT_EQ(none.picture.pixels[i], 0);
        }
}

// What a coat reflects of its lights is found before the walk and is not the walk's: a black medium has nothing in its
// layers.
TEST(ScatterLayers, LeaveOutTheCoat) {
    scene::Scene scene = ball({.albedo = {0, 0, 0}}, 1e4);
    for (scene::Material &material : scene.materials)
        material[shared::PARAMETER_specular_weight].value = Vec3::Constant(1);
    scene.lights = {rect_light({0, 0, 9}, {3, 0, 0}, {0, -3, 0}, {5, 5, 5})};
    const Rendered image = with(scene);
    EXPECT_GT(mean_of(image, root).value, 1e-3);
    for (const std::size_t order : {zero, single, multiple}) EXPECT_LE(mean_of(image, order).value, 1e-6);
}

// The walk that a path took first decides, not the last: a path that left a clear ball and walked in a dense one is the
// ball's.
TEST(ScatterLayers, FirstWalkDecides) {
    const scene::Scene scene = scene_of(R"({
        "camera": {"type": "orthographic", "position": [0, 0, 3], "height": 0.2}, "image": {"width": 16, "height": 16},
        "render": {"spp": 16, "max_depth": 0},
        "materials": {
          "clear": {"subsurface_weight": 1, "subsurface_albedo": 1, "subsurface_radius": 1e4, "subsurface_radius_scale": 1,
                    "specular_weight": 0},
          "dense": {"subsurface_weight": 1, "subsurface_albedo": 1, "subsurface_radius": 0.1, "subsurface_radius_scale": 1,
                    "specular_weight": 0}},
        "objects": [{"sphere": {"segments": 32}, "material": "clear"},
                    {"box": {"min": [-9, -9, -3], "max": [9, 9, -2]}, "material": "dense"}],
        "lights": [{"type": "environment", "radiance": 1}]})");
    const Rendered image = with(scene);
    EXPECT_NEAR(mean_of(image, zero).value, 1, 1e-3);
    EXPECT_GT(image.statistics[shared::COUNTER_steps], 5 * image.statistics[shared::COUNTER_paths])
        << "the box is not met";
}

// Nothing is compiled or kept for layers that nobody asked for, and asking for them does not touch the others.
TEST(ScatterLayers, CostNothingUnlessAskedFor) {
    scene::Scene scene = io::load_scene(NACRE_SCENES "/features/skin.json");
    scene.render.control = false; // pictures of orders have none, and are to be the same here
    scene.image = {32, 32};
    scene.render.spp = 3;
    const auto bytes = [](const Rendered &image, const std::string &name) {
        for (const auto &[buffer, size] : image.statistics.memory)
            if (buffer == name) return size;
        return std::size_t(0);
    };
    const auto has_feature = [](const Rendered &image) {
        const auto &all = image.statistics.features;
        return std::find(all.begin(), all.end(), "scatter_aov") != all.end();
    };
    const render::Layers surface{.albedo = true, .normal = true, .depth = true};
    render::Layers both = orders;
    both.albedo = both.normal = both.depth = true;
    const Rendered none = rendered(scene), some = with(scene, surface), all = with(scene, both);
    const Rendered only = with(scene);
    EXPECT_FALSE(has_feature(none) || has_feature(some));
    EXPECT_TRUE(has_feature(all) && has_feature(only));
    EXPECT_EQ(bytes(none, "layers"), 0u);
    EXPECT_EQ(bytes(some, "layers"), 2 * bytes(some, "radiance"));
    EXPECT_EQ(bytes(only, "layers"), bytes(only, "radiance"));
    EXPECT_EQ(bytes(all, "layers"), 3 * bytes(all, "radiance"));
    EXPECT_EQ(3 * bytes(some, "film"), 5 * bytes(none, "film")); // planes
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            for (std::size_t c = 0; c < 11; ++c) ASSERT_EQ(some.at(x, y, c), all.at(x, y, c));
            for (std::size_t c = 0; c < 10; ++c) ASSERT_EQ(only.at(x, y, 4 + c), all.at(x, y, 11 + c));
            for (std::size_t c = 0; c < 4; ++c) ASSERT_EQ(none.at(x, y, c), all.at(x, y, c));
        }
}

} // namespace
} // namespace nacre
