// Channels whose mean free paths differ by up to a million.
#include "stress/bodies.h"
#include "stress/tally.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace nacre::stress {
namespace {

using namespace shared;

void check(Guiding guiding, std::uint32_t spp) {
    Tally tally(guiding == GUIDING_NONE ? "Channels, classical walks" : "Channels, guided walks");
    for (const ChannelSampling sampling : {CHANNEL_HERO, CHANNEL_THROUGHPUT})
        for (const double free_path : {1e-2, 1., 1e3}) {
            std::vector<Body> bodies;
            for (const double g : {-.9, .9, .9999})
                for (const double ratio : {1., 1e-1, 1e-3, 1e-6})
                    for (const Vec3 &albedo : {Vec3(0, .5, 1), Vec3(1, .5, 0), Vec3(.9, .9, .9), Vec3(1, 1, 1)})
                        for (const double bleed : {0., 1e-3, 1., 1e4})
                            for (const FlightLaw flight : {FLIGHT_RENEWAL, FLIGHT_RECIPROCAL})
                                bodies.push_back({.g = g,
                                                  .bleed = bleed,
                                                  .albedo = albedo,
                                                  .free_path = free_path,
                                                  .scale = {1, std::sqrt(ratio), ratio},
                                                  .flight = flight,
                                                  .max_depth = 1024});
            // Scatters are rare in thin bodies, but the weights of all walks know of them.
            const std::uint32_t samples = free_path > 1 ? std::max(spp, 1024u) : spp;
            const Shown shown = show(bodies, {.spp = samples, .guiding = guiding, .sampling = sampling});
            for (std::size_t i = 0; i < bodies.size(); ++i) {
                const Body &body = bodies[i];
                tally.add({{"ratio", body.scale.z()},
                           {"g", body.g},
                           {"albedo", body.albedo.x()},
                           {"bleed", body.bleed},
                           {"reciprocal", body.flight},
                           {"free path", free_path},
                           {"hero", sampling == CHANNEL_HERO}},
                          shown.bodies[i].sound(1.0 / samples), shown.bodies[i].text());
            }
            EXPECT_EQ(shown.statistics[COUNTER_non_finite], 0u) << "free path " << free_path;
        }
    tally.expect_all();
}

TEST(Channels, Classical) { check(GUIDING_NONE, 16); }
TEST(Channels, Guided) { check(GUIDING_EIGEN, 16); }
TEST(LongChannels, Classical) { check(GUIDING_NONE, 1024); }
TEST(LongChannels, Guided) { check(GUIDING_EIGEN, 1024); }

} // namespace
} // namespace nacre::stress
