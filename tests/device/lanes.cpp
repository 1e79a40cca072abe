// What is written over lanes gives each lane the bits that it would get alone: hash, and whole flights with their
// weights.
#include "device/lane_probe.h"
#include <algorithm>
#include <bit>
#include <cmath>
#include <gtest/gtest.h>

namespace nacre::test {
namespace {

using Bits = std::vector<std::uint32_t>;
constexpr std::uint32_t count = 1 << 14;

Bits numbers() {
    Bits in(count);
    for (std::uint32_t i = 0; i < count; ++i) in[i] = i * 2654435761u; // high bits and low ones
    return in;
}

TEST(Lanes, Hash) {
    const Bits in = numbers();
    for (const int lanes : lane_counts) {
        const Bits words = run_lane_hash(lanes, in);
        EXPECT_TRUE(std::equal(words.begin(), words.begin() + 4 * count, words.begin() + 4 * count)) << lanes;
    }
}

TEST(Lanes, Unit) {
    const Bits in = numbers();
    for (const int lanes : lane_counts) {
        const Bits found = run_function(lanes, Function::unit, in);
        for (std::uint32_t i = 0; i < count; ++i)
            ASSERT_EQ(std::bit_cast<float>(found[i]), (float(in[i] >> 9) + .5f) * 0x1p-23f) << lanes;
    }
}

TEST(Lanes, WalksAreThoseOfOneLane) {
    using namespace shared;
    const Bits in = numbers();
    for (const ChannelSampling sampling : {CHANNEL_SINGLE, CHANNEL_ALBEDO, CHANNEL_THROUGHPUT, CHANNEL_HERO}) {
        const Bits alone = run_lane_walk(1, in, sampling);
        for (const int lanes : lane_counts) EXPECT_EQ(run_lane_walk(lanes, in, sampling), alone) << lanes << " lanes";
        double survivors = 0, weight = 0;
        std::uint32_t lost = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            for (std::uint32_t c = 0; c < 3; ++c) {
                const float w = std::bit_cast<float>(alone[c * count + i]);
                ASSERT_TRUE(w == 0 || w >= 1e-20f) << "on its way to a denormal number: " << w;
                lost += w == 0;
            }
            survivors += std::bit_cast<float>(alone[9 * count + i]);
            weight += std::bit_cast<float>(alone[i]);
            ASSERT_EQ(std::bit_cast<float>(alone[10 * count + i]), 0) << "density of a flight to the surface";
            ASSERT_EQ(std::bit_cast<float>(alone[11 * count + i]), 0) << "density of a flight to a scatter";
        }
        EXPECT_TRUE(std::isfinite(weight) && weight > 0);
        EXPECT_GT(lost, count / 4) << "the third channel's of the others' walks";
        EXPECT_TRUE(survivors > .1 * count && survivors < count) << "some walks end, some do not";
    }
}

} // namespace
} // namespace nacre::test
