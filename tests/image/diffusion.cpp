// The diffusion models through the renderer: the colour asked for on a flat patch, a ball of known reflectance,
// extremes, and models side by side.
#include "device/diffusion_probe.h"
#include "device/probe.h"
#include "image/rendered.h"
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>

namespace nacre {
namespace {

constexpr const char *models[] = {"dipole", "better_dipole", "burley"};

// A body in a white sky, of this material beside its model. `camera` is the height of the orthographic picture.
scene::Scene body(const std::string &object, const std::string &material, double camera, int size = 64, int spp = 64) {
    return scene_of(fmt::format(
        R"({{"camera": {{"type": "orthographic", "position": [0, 0, 3], "target": [0, 0, 0], "height": {}}},
             "image": {{"width": {}, "height": {}}}, "render": {{"spp": {}}},
             "materials": {{"medium": {{"specular_weight": 0, {}}}}},
             "objects": [{{{}, "material": "medium"}}],
             "lights": [{{"type": "environment", "radiance": 1}}]}})",
        camera, size, size, spp, material, object));
}

// A box 1e4 mean free paths deep and wide is flat: at most 1e-4 of a white dipole's light reaches that far.
TEST(Diffusion, FlatPatchShowsTheColor) {
    const std::array<double, 3> color = {.95, .5, .1};
    for (const char *model : models)
        for (const double g : {0., .8}) {
            const scene::Scene scene = body(
                R"("box": {"min": [-1, -1, -1], "max": [1, 1, 1]})",
                fmt::format(
                    R"("subsurface_weight": 1, "subsurface_model": "{}", "subsurface_color": [{}, {}, {}], "subsurface_radius": {},
                               "subsurface_radius_scale": [1, 0.5, 0.25], "subsurface_scatter_anisotropy": {})",
                    model, color[0], color[1], color[2], 2e-4 * (1 - g), g),
                0.1);
            const auto found = rendered_to(scene, {4e-3, 3e-3, 1.5e-3});
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(found[c].value, color[c], 4 * found[c].error + 2e-4)
                    << model << ", g " << g << ", channel " << c << ", standard error " << found[c].error;
        }
}

// Where a mean free path is less than positions round, distances along the probe's line mean nothing, and yet the
// channels' shares are right. (Straight flights have no such luck, nor have walks.)
TEST(Diffusion, FlatPatchDenserThanRounding) {
    const std::array<double, 3> color = {.9, .5, .2};
    const auto found = rendered_to(body(R"("box": {"min": [-1, -1, -1], "max": [1, 1, 1]})",
                                        R"("subsurface_weight": 1, "subsurface_model": "burley",
                                           "subsurface_color": [0.9, 0.5, 0.2], "subsurface_radius": 2e-7,
                                           "subsurface_radius_scale": [1, 0.2, 0.1])",
                                        0.1),
                                   {4e-3, 3e-3, 1.5e-3});
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c].value, color[c], 4 * found[c].error) << "channel " << c;
}

// Within the distance d of one of its points a ball has the area pi d^2, as a plane has: so the multiple lobe returns
// what the profile holds within the diameter. Unscattered light is (1 - (1 + 2 tau) e^(-2 tau)) / (2 tau^2) for the
// optical radius tau, light scattered once is known from walks. The ball's facets are worth 1e-3.
TEST(Diffusion, BallReturnsWhatItsProfileHolds) {
    constexpr double albedo = .9;
    for (const double tau : {.5, 3.}) {
        test::Probe walk;
        walk.albedo = {float(albedo), float(albedo), float(albedo), 0};
        walk.thickness = -float(tau);
        const test::Walks walks = test::run_walks(walk, 1 << 21);
        const double zero = (1 - (1 + 2 * tau) * std::exp(-2 * tau)) / (2 * tau * tau);
        for (const char *model : models) {
            const bool burley = std::string(model) == "burley";
            const scene::Scene scene =
                body(R"("sphere": {"segments": 256}, "smooth": false)",
                     fmt::format(R"("subsurface_weight": 1, "subsurface_model": "{}", "{}": {}, "subsurface_radius": {},
                                    "subsurface_radius_scale": 1)",
                                 model, burley ? "subsurface_color" : "subsurface_albedo", albedo, 1 / tau),
                     1.4);
            const test::ExactProfile profile{std::string(model) == "dipole" ? shared::MODEL_DIPOLE
                                             : burley                       ? shared::MODEL_BURLEY
                                                                            : shared::MODEL_BETTER_DIPOLE,
                                             albedo, albedo};
            const double straight = burley ? 0 : zero + albedo * walks.by_scatters[1].mean;
            const double exact = straight + profile.within(2 * tau);
            const Mean found = rendered_to(scene, {2e-3, 2e-3, 2e-3})[0];
            EXPECT_NEAR(found.value, exact, 4 * std::hypot(found.error, walks.by_scatters[1].error) + 1e-3)
                << model << ", optical radius " << tau << ", standard error " << found.error;
        }
    }
}

// Light that comes from one side tells where the path leaves: of a ball lit along its axis, the pole of the lit side
// and that of the other, where what arrives at the distance d has the cosine 1 - d^2 / 2.
TEST(Diffusion, PolesOfABallLitFromOneSide) {
    constexpr double color = .9, tau = 2;
    const test::ExactProfile profile{shared::MODEL_BURLEY, 0, color};
    for (const double side : {-1., 1.}) { // direction of the light; the camera looks along -1
        scene::Scene scene = body(R"("sphere": {"segments": 256}, "smooth": true)",
                                  fmt::format(R"("subsurface_weight": 1, "subsurface_model": "burley",
                                                 "subsurface_color": {}, "subsurface_radius": {},
                                                 "subsurface_radius_scale": 1)",
                                              color, 1 / tau),
                                  0.05);
        scene.lights[0].kind = shared::LIGHT_DIRECTIONAL;
        scene.lights[0].radiance.setConstant(std::numbers::pi);
        scene.lights[0].direction = {0, 0, side};
        double exact = 0;
        constexpr int n = 20000;
        for (int i = 0; i < n; ++i) {
            const double d = 2 * (i + .5) / n, cosine = -side * (1 - d * d / 2);
            if (cosine > 0)
                exact += profile.reflectance(d * tau) * tau * tau * cosine * 2 * std::numbers::pi * d * 2 / n;
        }
        const double largest_error = .005 * exact;
        const Mean found = rendered_to(scene, {largest_error, largest_error, largest_error})[0];
        EXPECT_NEAR(found.value, exact, 4 * found.error + 2e-3 * exact) << (side < 0 ? "lit" : "dark") << " side";
    }
}

// A shell inside the body is passed, as walks pass it, and a hole on the other side is none for what the camera sees.
TEST(Diffusion, InnerShellsAndHoles) {
    for (const char *model : models) {
        const scene::Scene plain =
            body(R"("sphere": {"segments": 64}, "smooth": false)",
                 fmt::format(R"("subsurface_weight": 1, "subsurface_model": "{}", "subsurface_color": [0.9, 0.5, 0.2],
                                "subsurface_radius": 0.2)",
                             model),
                 1.4);
        scene::Scene shells = plain, hole = plain;
        scene::Mesh &mesh = shells.objects[0].mesh;
        const scene::Mesh inner = scene::make_sphere({0, 0, 0.1}, 0.8, 64);
        const auto first = std::uint32_t(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), inner.positions.begin(), inner.positions.end());
        for (const auto &[a, b, c] : inner.triangles) mesh.triangles.push_back({first + a, first + b, first + c});
        mesh.normals.clear();
        mesh.uvs.clear();
        std::erase_if(hole.objects[0].mesh.triangles, [&, done = false](const auto &corner) mutable {
            const bool behind = !done && hole.objects[0].mesh.positions[corner[0]].z() < -.99;
            done = done || behind;
            return behind;
        });
        ASSERT_EQ(hole.objects[0].mesh.triangles.size() + 1, plain.objects[0].mesh.triangles.size());
        const auto wanted = covered_mean(rendered(plain).picture);
        for (const scene::Scene *scene : {&shells, &hole}) {
            const auto found = covered_mean(rendered(*scene).picture);
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(found[c].value, wanted[c].value, 4 * std::hypot(found[c].error, wanted[c].error) + 5e-4)
                    << model << (scene == &shells ? ", shells" : ", hole") << ", channel " << c;
        }
    }
}

// Nothing is NaN or brighter than it may be: black and white, nearly clear and nearly opaque; g at its ends.
TEST(Diffusion, Extremes) {
    for (const char *model : models)
        for (const char *color : {"[0, 0, 0]", "[1, 1, 1]", "[0, 0.5, 1]"})
            for (const char *radius : {"1e-30", "1e30"})
                for (const double g : {-.9999, .9999}) {
                    SCOPED_TRACE(fmt::format("{} {} radius {} g {}", model, color, radius, g));
                    scene::Scene scene = body(
                        R"("sphere": {"segments": 24}, "smooth": false)",
                        fmt::format(
                            R"("subsurface_weight": 1, "subsurface_model": "{}", "subsurface_color": {}, "subsurface_radius": {},
                                       "subsurface_radius_scale": [1, 0.01, 1], "subsurface_scatter_anisotropy": {})",
                            model, color, radius, g),
                        1.4, 8, 16);
                    const Rendered found = rendered(scene);
                    EXPECT_EQ(found.statistics[shared::COUNTER_non_finite], 0u);
                    for (const Mean &mean : covered_mean(found.picture)) {
                        EXPECT_TRUE(std::isfinite(mean.value));
                        EXPECT_LE(mean.value, 1.01 + 4 * mean.error);
                    }
                }
}

// Where light leaves where it enters a painted surface looks like paint, in the mean and from light to dark. Paint in a
// white sky has no noise.
TEST(Diffusion, TexturedColor) {
    const std::string box = R"("box": {"min": [-1, -1, -1], "max": [1, 1, 1]})";
    const std::string texture = fmt::format(R"({{"texture": "{}/features/checker.png"}})", NACRE_SCENES);
    const Rendered paint = rendered(body(box, R"("base_color": )" + texture, 2));
    const auto mean_paint = covered_mean(paint.picture);
    for (const char *model : models) {
        const Rendered found = rendered(body(box,
                                             fmt::format(R"("subsurface_weight": 1, "subsurface_model": "{}",
                                                            "subsurface_color": {}, "subsurface_radius": 1e-4)",
                                                         model, texture),
                                             2));
        for (std::size_t c = 0; c < 3; ++c) {
            double sum = 0, squares = 0, contrast = 0, contrast_squares = 0, spread = 0;
            for (int y = 0; y < 64; ++y)
                for (int x = 0; x < 64; ++x) {
                    const double lighter = paint.at(x, y, c) - mean_paint[c].value;
                    const double difference = found.at(x, y, c) - paint.at(x, y, c);
                    sum += difference;
                    squares += difference * difference;
                    contrast += difference * lighter;
                    contrast_squares += std::pow(difference * lighter, 2);
                    spread += lighter * lighter;
                }
            EXPECT_NEAR(sum, 0, 4 * std::sqrt(squares)) << model << ", channel " << c;
            EXPECT_NEAR(contrast, 0, 4 * std::sqrt(contrast_squares)) << model << ", channel " << c;
            EXPECT_LE(4 * std::sqrt(contrast_squares), .1 * spread) << "too noisy to tell";
        }
    }
}

} // namespace
} // namespace nacre
