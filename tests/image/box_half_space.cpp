// Rendered boxes so thick that they are half-spaces, against values known without Monte Carlo.
#include "device/probe.h"
#include "image/box_scene.h"
#include <cmath>
#include <gtest/gtest.h>

namespace nacre {
namespace {

using Three = std::array<double, 3>;

// How deep and wide the boxes are, in mean free paths.
constexpr double thickness = 1e6;

// Most that a flight of more than half the box's width can change. A walk of albedo alpha carries weight through at
// most 1/(1-alpha) flights in the mean; each is so long with probability T, at bleed 1 the largest, 1/(1+tau).
double finite_thickness(double albedo, double bleed) {
    return bleed > 0 ? std::pow(1 + bleed * thickness / 2, -1 / bleed) / (1 - albedo) : 0;
}

Three quick_errors(const Three &exact) {
    Three errors;
    for (std::size_t c = 0; c < 3; ++c) errors[c] = std::max(1e-3 * exact[c], 2e-4);
    return errors;
}

void check(const Medium &medium, const Three &exact, const Three &errors, double error_of_exact = 0) {
    const auto found = rendered_to(half_space(medium, thickness), errors);
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(found[c].value, exact[c],
                    4 * std::hypot(found[c].error, error_of_exact) + finite_thickness(medium.albedo[c], medium.bleed))
            << "albedo " << medium.albedo[c] << ", g " << medium.g << ", bleed " << medium.bleed << ", standard error "
            << found[c].error;
}

// R = (1-r)/(1+r), r = sqrt(1-albedo), whatever the law of flights (Sparre Andersen): one picture, three albedos.
void check_universal(double bleed, bool quick) {
    const Medium medium{.albedo = {.5, .9, .99}, .bleed = bleed, .entry = "uniform"};
    Three exact;
    for (std::size_t c = 0; c < 3; ++c) {
        const double r = std::sqrt(1 - medium.albedo[c]);
        exact[c] = (1 - r) / (1 + r);
    }
    check(medium, exact, quick ? quick_errors(exact) : Three{1e-4, 1e-4, 1e-4});
}

TEST(Box, UniversalLawExponential) { check_universal(0, true); }
TEST(Box, UniversalLawBleedHalf) { check_universal(.5, true); }
TEST(Box, UniversalLawBleedOne) { check_universal(1, true); }
// A walk starts on its triangle, not below it by a share of the triangle's size: that cost 1 % here.
TEST(Box, LargeTriangles) {
    const Three exact = {(1 - std::sqrt(.5)) / (1 + std::sqrt(.5)), (1 - std::sqrt(.1)) / (1 + std::sqrt(.1)),
                         9.0 / 11};
    const auto found = rendered_to(plain_box({.albedo = {.5, .9, .99}, .entry = "uniform"}, 1e4), quick_errors(exact));
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c].value, exact[c], 4 * found[c].error);
}

TEST(LongBox, UniversalLaw) {
    for (const double bleed : {0., .5, 1.}) check_universal(bleed, false);
}

struct Known {
    double g, bleed;
    Three albedo, reflectance;
};

// H-functions and discrete ordinates in float64; Lambertian entry.
const Known lambert[] = {
    {0, 0, {.5, .9, .99}, {.1465443807, .4780244892, .7945636529}},
    {0, .5, {.5, .9, .99}, {.1496789652, .4832079736, .7972926928}},
    {0, 1, {.5, .9, .99}, {.1524930237, .4883614567, .8005208025}},
    {.5, 0, {.9, .9, .9}, {.36015164, .36015164, .36015164}},
    {.8, 0, {.9, .99, .9}, {.21672348, .60264779, .21672348}},
    {.9, 0, {.9, .9, .9}, {.13258493, .13258493, .13258493}},
};

void check_lambert(const Known &known, bool quick) {
    check({.albedo = known.albedo, .g = known.g, .bleed = known.bleed}, known.reflectance,
          quick ? quick_errors(known.reflectance) : Three{1e-4, 1e-4, 1e-4});
}

TEST(Box, LambertEntryExponential) { check_lambert(lambert[0], true); }
TEST(Box, LambertEntryBleedHalf) { check_lambert(lambert[1], true); }
TEST(Box, LambertEntryBleedOne) { check_lambert(lambert[2], true); }
TEST(Box, LambertEntryForwardHalf) { check_lambert(lambert[3], true); }
TEST(Box, LambertEntryForward) { check_lambert(lambert[4], true); }
TEST(Box, LambertEntryVeryForward) { check_lambert(lambert[5], true); }
TEST(LongBox, LambertEntry) {
    for (const Known &known : lambert) check_lambert(known, false);
}

// No literature value for backward scattering: the probe's walks below an analytic plane are the reference.
void check_backward(double error) {
    test::Probe probe;
    probe.albedo = {.5f, .9f, .99f, 0};
    probe.anisotropy = -.5f;
    const test::Walks reference = test::run_walks_to(probe, error);
    const Three wanted = {reference.near[0].mean, reference.near[1].mean, reference.near[2].mean};
    check({.albedo = {.5, .9, .99}, .g = -.5}, wanted, {error, error, error}, error);
}

TEST(Box, LambertEntryBackward) { check_backward(4e-4); }
TEST(LongBox, LambertEntryBackward) { check_backward(1e-4); }

} // namespace
} // namespace nacre
