// A walk's twin in a half-space (kernels/walk/twin.h), where its value is known, and however it is brought to the
// machine.
#include "albedo/inversion.h"
#include "albedo/returned.h"
#include "image/rendered.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>

namespace nacre {
namespace {

/// A face of a block that is a half-space to walks of this mean free path, seen from straight above in a white sky.
scene::Scene face(double radius) {
    return scene_of(fmt::format(R"({{"camera": {{"type": "orthographic", "position": [0, 0, 1], "height": 0.1}},
        "image": {{"width": 32, "height": 32}}, "render": {{"spp": 1}},
        "materials": {{"m": {{"subsurface_weight": 1, "subsurface_color": [0.8, 0.5, 0.4], "subsurface_radius": {},
            "subsurface_radius_scale": [1, 0.35, 0.2], "specular_weight": 0}}}},
        "objects": [{{"box": {{"min": [-1, -1, -1], "max": [1, 1, 0]}}, "material": "m"}}],
        "lights": [{{"type": "environment"}}]}})",
                                radius));
}

// Walk and twin leave together, in the same light: each sample is the colour, but for where a flight is found to end in
// a mesh and below a plane: a few 1e-6 of the block's size, in mean free paths of the blue light.
TEST(Control, EverySampleOfAHalfSpaceIsItsColor) {
    const double radius = .005;
    const Rendered found = rendered(face(radius));
    const double wanted[] = {.8, .5, .4}, tolerance = 1e-5 / (.2 * radius);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                ASSERT_NEAR(double(found.at(x, y, c)), wanted[c], wanted[c] * tolerance) << x << ", " << y;
}

// What has no known colour has no control variate: media given by their albedo, other entries, capped walks, thin
// objects; nor have pictures of scattering orders one. Then nothing of it is in the program.
TEST(Control, OnlyWhereTheColorIsKnown) {
    const auto controlled = [](const scene::Scene &scene, const render::Layers &layers = {}) {
        render::Options options;
        options.layers = layers;
        return std::ranges::count(rendered(scene, options).statistics.features, "control") == 1;
    };
    const scene::Scene known = face(.005);
    EXPECT_TRUE(controlled(known));
    const auto changed = [&](auto &&change) {
        scene::Scene scene = known;
        change(scene);
        return scene;
    };
    EXPECT_FALSE(controlled(changed([](scene::Scene &s) { s.materials[0].inversion = shared::INVERSION_NONE; })));
    EXPECT_FALSE(controlled(changed([](scene::Scene &s) { s.materials[0].inversion = shared::INVERSION_MEMO; })));
    EXPECT_FALSE(controlled(changed([](scene::Scene &s) { s.materials[0].entry = shared::ENTRY_REFRACTED; })));
    EXPECT_FALSE(controlled(changed([](scene::Scene &s) { s.materials[0].internal_reflection = true; })));
    EXPECT_FALSE(controlled(changed([](scene::Scene &s) { s.materials[0].max_depth = 1000; })));
    EXPECT_FALSE(controlled(changed([](scene::Scene &s) { s.render.control = false; })));
    EXPECT_FALSE(controlled(changed([](scene::Scene &s) {
        s.materials[0][shared::PARAMETER_subsurface_bleed].value.setConstant(1); // deeper than the tables
    })));
    EXPECT_FALSE(controlled(face(2)));
    // Nothing is thick against the diffusion length of white.
    EXPECT_FALSE(controlled(changed([](scene::Scene &s) {
        s.materials[0][shared::PARAMETER_subsurface_color].value = {1, .5, .4};
    })));
    EXPECT_FALSE(controlled(known, {.zero = true}));
}

// Walks in grey media have little noise of their own, and those under bleed, in dark media and with guides are not
// worth the time: there a body must be thicker.
TEST(Control, OnlyWhereItPays) {
    const auto controlled = [](const Vec3 &color, const Vec3 &scale, double radius, double bleed = 0) {
        scene::Scene scene = face(radius); // .5 thick in the mean
        scene.materials[0][shared::PARAMETER_subsurface_color].value = color;
        scene.materials[0][shared::PARAMETER_subsurface_radius_scale].value = scale;
        scene.materials[0][shared::PARAMETER_subsurface_bleed].value.setConstant(bleed);
        return std::ranges::count(rendered(scene).statistics.features, "control") == 1;
    };
    const Vec3 grey = {.8, .8, .8}, even = {1, 1, 1}, uneven = {1, .35, .2}; // diffusion length: 5.9 mean free paths
    EXPECT_TRUE(controlled(grey, even, .02));
    EXPECT_FALSE(controlled(grey, even, .03));
    EXPECT_TRUE(controlled(grey, uneven, .15));
    EXPECT_TRUE(controlled(grey, uneven, .15, .5));
    EXPECT_FALSE(controlled(grey, uneven, .15, .75));
    EXPECT_TRUE(controlled({.8, .5, .4}, even, .1));
    EXPECT_FALSE(controlled({1, 1, 1}, even, .005));
    const Vec3 dark = {.02, .02, .02}; // .6 mean free paths
    EXPECT_TRUE(controlled(dark, even, .1));
    EXPECT_FALSE(controlled(dark, even, .2));

    EXPECT_TRUE(controlled({.8, .5, .4}, uneven, .5));
}

// Plates have one of both sides, however thin; balls, cubes and beams are none.
TEST(Control, OfBothSidesOfPlates) {
    const auto slabs = [](const scene::Scene &scene) {
        return std::ranges::count(rendered(scene).statistics.features, "slabs") == 1;
    };
    scene::Scene scene = face(.1);
    const auto set_box = [&](const Vec3 &size) { scene.objects[0].mesh = scene::make_box(-size, Vec3(0, 0, 0)); };
    set_box({4, 4, 1});
    EXPECT_TRUE(slabs(scene));
    EXPECT_EQ(std::ranges::count(rendered(scene).statistics.features, "guide_eigen"), 1);
    set_box({4, .1, 4});
    EXPECT_TRUE(slabs(scene));
    scene.materials[0][shared::PARAMETER_subsurface_radius].value.setConstant(10);
    EXPECT_TRUE(slabs(scene));
    set_box({2, 2, 1});
    EXPECT_FALSE(slabs(scene));
    set_box({10, 2, 1});
    EXPECT_FALSE(slabs(scene));
    scene.objects[0].mesh = scene::make_sphere({0, 0, 0}, 1, 32);
    EXPECT_FALSE(slabs(scene));
}

/// What every sample of a plate shows, in a white sky or before a lamp.
void expect_share(double thickness, double g, double bleed, bool lamp, const Vec3 &color = {.8, .5, .4}) {
    SCOPED_TRACE(testing::Message() << thickness << ", g " << g << ", bleed " << bleed << (lamp ? ", lamp" : ""));
    scene::Scene scene = face(.01);
    scene::Material &m = scene.materials[0];
    m[shared::PARAMETER_subsurface_color].value = color;
    m[shared::PARAMETER_subsurface_scatter_anisotropy].value.setConstant(g);
    m[shared::PARAMETER_subsurface_bleed].value.setConstant(bleed);
    scene.objects[0].mesh = scene::make_box({-1, -1, -thickness}, {1, 1, 0});
    if (lamp) {
        scene.lights[0].kind = shared::LIGHT_DIRECTIONAL;
        scene.lights[0].direction = {0, 0, 1};
        scene.lights[0].radiance.setConstant(std::numbers::pi); // a white surface shows radiance 1
    }
    const Rendered found = rendered(scene);
    const double scale[] = {1, .35, .2};
    for (int c = 0; c < 3; ++c) {
        const double albedo = albedo::albedo(shared::INVERSION_TABLE, color[c], {.anisotropy = g, .bleed = bleed});
        const albedo::Ordinates ordinates(g, bleed, shared::FLIGHT_RENEWAL, bleed > 0 ? 8 : 24, 1e-6);
        const albedo::Returned slab(ordinates, g, albedo, thickness / (.01 * scale[c]));
        const double wanted = slab.transmitted() + (lamp ? 0 : slab.reflected());
        // Where a flight is found to end: EverySampleOfAHalfSpaceIsItsColor.
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x)
                ASSERT_NEAR(double(found.at(x, y, c)), wanted, wanted * 2e-3 + 1e-6) << x << ", " << y << ", " << c;
    }
}

TEST(Control, EverySampleOfAPlateIsWhatGetsThroughAndComesBack) {
    for (const double thickness : {.003, .02, .08})
        for (const bool lamp : {false, true}) {
            if (thickness > .05 && !lamp) continue; // next to nothing gets through: a half-space
            expect_share(thickness, 0, 0, lamp);
            expect_share(thickness, .6, 0, lamp);
            expect_share(thickness, .3, .5, lamp);
        }
}

// They are too thin for twins in half-spaces, and next to nothing gets through them, of that which has not scattered
// most.
TEST(Control, EverySampleOfADarkPlateToo) {
    for (const double g : {0., .8}) {
        expect_share(.05, g, 0, true, Vec3::Constant(.02));
        if (g > 0) expect_share(.05, g, 0, false, Vec3::Constant(.02));
    }
}

// A channel without depth, and one that does not get through, are numbers all the same.
TEST(Control, PlatesOfExtremeMedia) {
    for (const Vec3 &scale : {Vec3(1, 0, 1e-6), Vec3(1e-3, 1e3, 1e9)}) {
        scene::Scene scene = face(.05);
        scene.materials[0][shared::PARAMETER_subsurface_radius_scale].value = scale;
        scene.objects[0].mesh = scene::make_box({-1, -1, -.1}, {1, 1, 0});
        const Rendered found = rendered(scene);
        EXPECT_EQ(std::ranges::count(found.statistics.features, "slabs"), 1);
        EXPECT_EQ(found.statistics[shared::COUNTER_non_finite], 0u);
    }
}

// A ball before a lamp, of which the camera sees the other side: as without one, to the bit.
TEST(Control, NoneWhereTheCameraSeesNoLight) {
    scene::Scene scene = scene_of(R"({"image": {"width": 24, "height": 24}, "render": {"spp": 4},
        "camera": {"position": [0, 0, 5], "target": [0, 0, 0], "fov": 30},
        "materials": {"m": {"subsurface_weight": 1, "subsurface_color": [0.8, 0.5, 0.4], "subsurface_radius": 0.2}},
        "objects": [{"sphere": {"segments": 64}, "material": "m"}],
        "lights": [{"type": "environment", "radiance": 0.02},
                   {"type": "rect", "center": [0, 0, -6], "u": [5, 0, 0], "v": [0, 5, 0], "radiance": 10}]})");
    const Rendered with = rendered(scene);
    EXPECT_EQ(std::ranges::count(with.statistics.features, "control"), 1);
    scene.render.control = false;
    expect_same_pixels(with.picture, rendered(scene).picture);
}

// A cube before a lamp, whose edges show whether samples have camera rays of their own.
TEST(Control, CameraRaysAreSharedWhereNothingInSightHasOne) {
    const auto shares = [](double lamp, double depth, double radius) {
        const scene::Scene scene =
            scene_of(fmt::format(R"({{"image": {{"width": 24, "height": 24}}, "render": {{"spp": 4}},
            "camera": {{"position": [0, 0, 5], "target": [0, 0, 0], "fov": 30}},
            "materials": {{"m": {{"subsurface_weight": 1, "subsurface_color": [0.8, 0.5, 0.4], "subsurface_radius": {},
                "specular_weight": 0}}}},
            "objects": [{{"box": {{"min": [-0.9, -0.9, {}], "max": [0.9, 0.9, 0]}}, "material": "m"}}],
            "lights": [{{"type": "directional", "direction": [0, 0, {}]}}]}})",
                                 radius, -depth, lamp));
        const Rendered found = rendered(scene);
        EXPECT_EQ(std::ranges::count(found.statistics.features, "control"), 1);
        render::Options options;
        options.definitions = "-DCAMERA_RAY_SAMPLES=1u";
        return found.picture.pixels != rendered(scene, options).picture.pixels;
    };
    EXPECT_FALSE(shares(-1, 1.8, .02)); // the light goes along z: against the camera's side
    EXPECT_TRUE(shares(1, 1.8, .02));
    EXPECT_TRUE(shares(1, .3, .0075)); // a plate, but one that lets next to nothing through
    EXPECT_FALSE(shares(1, .3, .02));
}

// Walks with twins that go on for long, past the ends of launches: the same to the bit in any number of lanes, with and
// without clearance fields, in the program that knows all features.
TEST(Control, SameImageHoweverItIsTraced) {
    scene::Scene scene = scene_of(R"({"image": {"width": 32, "height": 32}, "render": {"spp": 4, "guiding": "none"},
        "camera": {"position": [0, 0, 5], "target": [0, 0, 0], "fov": 26},
        "materials": {"m": {"subsurface_weight": 1, "subsurface_color": [0.99, 0.9, 0.8], "subsurface_radius": 0.004,
            "subsurface_scatter_anisotropy": 0.3}},
        "objects": [{"sphere": {"segments": 64}, "material": "m"}],
        "lights": [{"type": "environment", "visible": false}]})");
    const Rendered found = rendered(scene);
    EXPECT_EQ(std::ranges::count(found.statistics.features, "control"), 1);
    const auto launches = [&](const std::string &name) {
        for (const render::Statistics::Kernel &kernel : found.statistics.kernels)
            if (kernel.compiled.name == name) return kernel.launches;
        return std::uint64_t(0);
    };
    EXPECT_GT(launches("trace_paths"), launches("accumulate")) << "no walk was suspended";
    render::Options options;
    options.generic = true;
    expect_same_pixels(found.picture, rendered(scene, options).picture);
    for (const int lanes : lane_counts()) {
        SCOPED_TRACE(lanes);
        scene.lanes = lanes;
        expect_same_pixels(found.picture, rendered(scene).picture);
    }
    scene.render.clearance = false;
    expect_same_pixels(found.picture, rendered(scene).picture);
}

} // namespace
} // namespace nacre
