// How large a scene is and where it lies does not matter.
#include "stress/bodies.h"
#include "stress/tally.h"
#include <cmath>
#include <gtest/gtest.h>

namespace nacre::stress {
namespace {

using namespace shared;

std::vector<Body> some_bodies() {
    std::vector<Body> bodies;
    for (const double g : {-.9, 0., .999})
        for (const double bleed : {0., 1.})
            for (const double free_path : {1e-3, 1e-1, 10.})
                bodies.push_back({.g = g, .bleed = bleed, .albedo = {.99, .9, .3}, .free_path = free_path});
    return bodies;
}

/// Every picture has its own samples: only their means are the same.
void check(const std::vector<double> &scales, const std::vector<double> &offsets, std::uint32_t spp) {
    Tally tally("Places");
    const std::vector<Body> bodies = some_bodies();
    const Shown here = show(bodies, {.spp = spp});
    std::uint32_t seed = 1;
    for (const double scale : scales)
        for (const double offset : offsets) {
            Look look{.spp = spp, .seed = ++seed};
            look.scale = scale;
            look.offset = Vec3(.6, -.64, .48) * (offset * scale);
            const Shown there = show(bodies, look);
            for (std::size_t i = 0; i < bodies.size(); ++i) {
                const Seen &a = here.bodies[i], &b = there.bodies[i];
                const Vec3 error = (a.error.cwiseAbs2() + b.error.cwiseAbs2()).cwiseSqrt();
                tally.add({{"scale", scale},
                           {"offset", offset},
                           {"g", bodies[i].g},
                           {"bleed", bodies[i].bleed},
                           {"free path", bodies[i].free_path}},
                          b.sound(1e-5) && ((a.mean - b.mean).cwiseAbs() - 4 * error).maxCoeff() <= 1e-5,
                          fmt::format("{}; at home {}", b.text(), a.text()));
            }
            EXPECT_EQ(there.statistics[COUNTER_missed], 0u) << "scale " << scale << ", offset " << offset;
        }
    tally.expect_all();
}

TEST(Places, ScaleAndOffset) { check({1e-6, 1, 1e6}, {0, 1e2, 1e5}, 64); }
TEST(LongPlaces, ScaleAndOffset) { check({1e-6, 1e-4, 1e-2, 1, 1e2, 1e4, 1e6}, {0, 1, 1e1, 1e2, 1e3, 1e4, 1e5}, 1024); }

} // namespace
} // namespace nacre::stress
