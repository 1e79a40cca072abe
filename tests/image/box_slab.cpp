// Bodies with a back: slabs and balls, against discrete ordinates in float64.
#include "image/box_scene.h"
#include <cmath>
#include <gtest/gtest.h>

namespace nacre {
namespace {

// Albedo .9 in every channel; grey walks carry the same weight in all three.
void check(const scene::Scene &scene, double exact, double error, double bound = 0) {
    const auto found = rendered_to(scene, {error, error, error});
    for (const Mean &mean : found) EXPECT_NEAR(mean.value, exact, 4 * mean.error + bound);
}

const Medium isotropic{.albedo = {.9, .9, .9}}, forward{.albedo = {.9, .9, .9}, .g = .8};

// Optical depth 2. In a white sky the front shows R + T; with a black plate behind, R alone.
void check_slabs(double error) {
    check(slab(isotropic, 2, true), .43714692, error);
    check(slab(isotropic, 2, false), .43714692 + .26558129, error);
    check(slab(forward, 2, true), .16223325, error);
    check(slab(forward, 2, false), .16223325 + .53081586, error);
}

TEST(Box, Slab) { check_slabs(4e-4); }
TEST(LongBox, Slab) { check_slabs(1e-4); }

// Flat facets make the ball thinner by (pi/256)^2 / 2 at most; what escapes changes by less than that.
constexpr double facets = 1e-4;

void check_balls(double error) {
    check(ball(isotropic, 1), .87800616, error, facets);
    check(ball(isotropic, 5), .62348458, error, facets);
}

TEST(Box, Ball) { check_balls(4e-4); }
TEST(LongBox, Ball) { check_balls(1e-4); }

} // namespace
} // namespace nacre
