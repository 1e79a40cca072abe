// Functions that all rooms lean on.
#include "device/probe.h"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace nacre::test {
namespace {

TEST(Elementary, SineAndCosineOfTurns) {
    constexpr std::uint32_t steps = 1 << 20; // a power of 2: the kernel's division is exact
    Probe probe;
    probe.count = steps + 1;
    const std::vector<float> values = run_probe("probe_sincos", probe, steps + 1, 2);
    double worst = 0;
    for (std::size_t i = 0; i <= steps; ++i) {
        const double angle = 2 * std::numbers::pi * double(i) / steps;
        worst =
            std::max({worst, std::abs(values[2 * i] - std::sin(angle)), std::abs(values[2 * i + 1] - std::cos(angle))});
    }
    EXPECT_LE(worst, 2e-7);
}

} // namespace
} // namespace nacre::test
