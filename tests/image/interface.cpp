// Bodies below a dielectric interface: refracted entry and reflection inside.
#include "image/box_scene.h"
#include "image/furnace_scene.h"
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>

namespace nacre {
namespace {

const std::string refracted = R"(, "subsurface_entry": "refracted")";
const std::string held = R"(, "subsurface_internal_reflection": true)";

// Reflection, entry and exit all have weight 1: every sample is white, at every roughness and from every side.
TEST(Interface, BearIsWhite) {
    Furnace furnace{.mesh = NACRE_SCENES "/bear/bear.ply", .specular = 1, .size = 24, .spp = 8};
    for (const double roughness : {0., .3, 1.})
        for (const std::string &inside : {std::string(), held}) {
            furnace.more = fmt::format(R"(, "specular_roughness": {}{}{})", roughness, refracted, inside);
            expect_exactly_white(furnace);
        }
    for (const char *smooth : {"false", "true"})
        for (const double specular : {0., .5}) {
            furnace.smooth = smooth;
            furnace.specular = specular;
            furnace.more = refracted + held;
            expect_exactly_white(furnace);
        }
}

// With every flight law and channel sampling that keeps weights equal in a grey medium; and entries of the memo.
TEST(Interface, EveryMediumIsWhite) {
    Furnace furnace{.mesh = NACRE_SCENES "/bear/bear.ply", .specular = 1, .size = 24, .spp = 4};
    furnace.more = refracted + held;
    for_all_media(furnace, expect_exactly_white);
    furnace.more = held;
    for_all_media(furnace, expect_exactly_white);
}

TEST(Interface, ColouredExtinctionIsWhiteInTheMean) {
    Furnace furnace{.mesh = NACRE_SCENES "/bear/bear.ply", .radius_scale = "[1, 0.35, 0.2]", .specular = 1, .spp = 64};
    furnace.more = refracted + held;
    for (const char *sampling : {"hero", "throughput"}) {
        furnace.sampling = sampling;
        expect_white_mean(furnace, 1e-2);
    }
}

/// An absorbing plate of optical depth `tau` in a white sky, seen under `degrees`.
scene::Scene plate(double tau, double ior, double weight, double degrees, const std::string &inside) {
    const double t = degrees * std::numbers::pi / 180;
    return scene_of(fmt::format(
        R"({{"camera": {{"type": "orthographic", "position": [{}, 0, {}], "height": 0.5}},
             "image": {{"width": 32, "height": 32}}, "render": {{"spp": 64, "max_depth": 0}},
             "materials": {{"glass": {{"subsurface_weight": 1, "subsurface_albedo": 0, "subsurface_radius": {},
               "subsurface_radius_scale": 1, "specular_roughness": 0, "specular_ior": {}, "specular_weight": {}{}{}}}}},
             "objects": [{{"box": {{"min": [-100, -100, -0.1], "max": [100, 100, 0.1]}}, "material": "glass"}}],
             "lights": [{{"type": "environment", "radiance": 1}}]}})",
        3 * std::sin(t), 3 * std::cos(t), .2 / tau, ior, weight, refracted, inside));
}

double fresnel(double cosine, double ior) {
    const double inner = std::sqrt(1 - (1 - cosine * cosine) / (ior * ior));
    const double p = (ior * cosine - inner) / (ior * cosine + inner),
                 s = (cosine - ior * inner) / (cosine + ior * inner);
    return (p * p + s * s) / 2;
}

// What is not absorbed on the way to and fro between two parallel faces that reflect R and let through a share x of the
// light each way: R + (1 - R)^2 x / (1 - R x). Not at grazing angles: there even the narrowest lobe of microfacets
// (alpha 1e-3, with GGX's tails) sends some light beyond the critical angle of the smooth faces, .3 % at 80 degrees.
TEST(Interface, PlateIsExact) {
    for (const double tau : {.1, 1.})
        for (const double ior : {1., 1.5, 2.5})
            for (const double degrees : {0., 60.})
                for (const std::string &inside : {std::string(), held}) {
                    SCOPED_TRACE(fmt::format("tau {} ior {} at {} degrees{}", tau, ior, degrees, inside));
                    const double cosine = std::cos(degrees * std::numbers::pi / 180);
                    const double r = fresnel(cosine, ior), along = std::sqrt(1 - (1 - cosine * cosine) / (ior * ior));
                    const double x = std::exp(-tau / along);
                    const double exact = !inside.empty() ? r + (1 - r) * (1 - r) * x / (1 - r * x) : r + (1 - r) * x;
                    const Rendered image = rendered(plate(tau, ior, 1, degrees, inside));
                    for (const Mean &mean : covered_mean(image.picture)) {
                        EXPECT_NEAR(mean.value, exact, 4 * mean.error + 2e-4);
                        EXPECT_LE(mean.error, 4e-3);
                    }
                }
}

// specular_weight 0: light is bent as always, and nothing is reflected short of the critical angle.
TEST(Interface, WeightChangesReflectionOnly) {
    const double x = std::exp(-1 / std::sqrt(1 - .75 / 2.25));
    for (const std::string &inside : {std::string(), held})
        for (const Mean &mean : covered_mean(rendered(plate(1, 1.5, 0, 60, inside)).picture))
            EXPECT_NEAR(mean.value, x, 4 * mean.error);
}

// The critical angle keeps light in: walks in a clear medium go round and round, and get longer by their reflections.
TEST(Interface, HeldWalksAreLonger) {
    Furnace furnace{.mesh = NACRE_SCENES "/bear/bear.ply", .specular = 1};
    furnace.more = refracted;
    const Rendered open = rendered(scene_of(furnace));
    furnace.more = refracted + held;
    const Rendered closed = rendered(scene_of(furnace));
    EXPECT_GT(double(closed.statistics[shared::COUNTER_steps]), 1.5 * double(open.statistics[shared::COUNTER_steps]));
}

// In a white furnace light fills a body evenly, whatever its interface: all parts of walks between two meetings with
// the surface together have the mean path 4 V / S, and a walk has 1 / (1 - F) of them, F being the mean reflectance
// from inside. Parallel rays on a ball come from all sides alike. The layers count a walk as one, however often it was
// held.
TEST(Interface, HeldWalksInABallAreExact) {
    constexpr double tau = 1, ior = 1.5;
    double through = 0; // 1 - mean reflectance from outside = ior^2 (1 - F)
    for (int i = 0; i < 10000; ++i) through += 2 * (i + .5) * 1e-4 * (1 - fresnel((i + .5) * 1e-4, ior)) * 1e-4;
    scene::Scene scene = ball({}, tau);
    scene.camera.height = 2.01; // all of the ball, so that every angle has its share
    scene.image = {384, 384};
    scene.render.spp = 1; // so that a pixel has one walk, which brings it a light of 1, or none
    for (scene::Material &material : scene.materials) {
        material.entry = shared::ENTRY_REFRACTED;
        material.internal_reflection = true;
        material[shared::PARAMETER_specular_weight].value = Vec3::Constant(1);
        material[shared::PARAMETER_specular_ior].value = Vec3::Constant(ior);
        material[shared::PARAMETER_specular_roughness].value = Vec3::Constant(0);
    }
    render::Options options;
    options.layers = {.zero = true, .single = true, .multiple = true, .steps = true};
    const io::Picture picture = rendered(scene, options).picture;
    double walks = 0, steps = 0, squares = 0, covered = 0, never = 0, once = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); i += 14) {
        const float *pixel = picture.pixels.data() + i;
        const bool walked = pixel[4] + pixel[7] + pixel[10] > .5f;
        EXPECT_EQ(pixel[4] > .5f, walked && pixel[13] == 0) << "zero is what never scattered";
        EXPECT_EQ(pixel[7] > .5f, walked && pixel[13] == 1);
        covered += pixel[3];
        walks += walked ? 1 : 0;
        steps += pixel[13];
        squares += pixel[13] * pixel[13];
        never += pixel[4];
        once += pixel[7];
    }
    EXPECT_NEAR(walks / covered, through, 4 * std::sqrt(through * (1 - through) / covered) + 1e-3);
    const double error = std::sqrt((squares / walks - std::pow(steps / walks, 2)) / walks);
    EXPECT_NEAR(steps / walks, 4 * tau / 3 * ior * ior / through, 4 * error);
    EXPECT_LE(error, .03);
    EXPECT_GT(never, .1 * walks);
    EXPECT_GT(once, .1 * walks);
}

// A cap counts the scatters of the whole walk, not of its last part.
TEST(Interface, CapCountsThroughReflections) {
    Furnace furnace{.mesh = NACRE_SCENES "/bear/bear.ply", .specular = 1};
    furnace.more = fmt::format(R"({}{}, "subsurface_max_depth": 6)", refracted, held);
    render::Options options;
    options.layers.steps = true;
    const Rendered image = rendered(scene_of(furnace), options);
    float most = 0;
    for (std::size_t i = 4; i < image.picture.pixels.size(); i += 5) most = std::max(most, image.picture.pixels[i]);
    EXPECT_LE(most, 6);
    EXPECT_GT(most, 4);
    EXPECT_GT(image.statistics[shared::COUNTER_capped], 0u);
}

// Smooth normals at silhouettes, roughness 0 and 1, a mirror-like and a vanishing interface: no sample is NaN.
TEST(Interface, NothingIsNaN) {
    for (const double roughness : {0., 1.})
        for (const double ior : {1., 1.0001, 100.}) {
            scene::Scene scene = io::load_scene(NACRE_SCENES "/features/internal_reflection.json");
            scene.image = {48, 48};
            scene.render.spp = 8;
            for (scene::Material &material : scene.materials) {
                material[shared::PARAMETER_specular_roughness].value = Vec3::Constant(roughness);
                material[shared::PARAMETER_specular_ior].value = Vec3::Constant(ior);
            }
            const Rendered image = rendered(scene);
            EXPECT_EQ(image.statistics[shared::COUNTER_non_finite], 0u) << roughness << " " << ior;
            EXPECT_EQ(image.statistics[shared::COUNTER_escaped], 0u);
        }
}

} // namespace
} // namespace nacre
