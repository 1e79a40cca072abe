// Where walks without a surface get to: <r^2> after n flights (physics.md, section 4), summed pair by pair,
//     <r^2> = sum_i <s_i^2> + 2 sum_(i<j) <s_i> <s_j> g^(j-i),
// so that laws whose first flight differs are covered too.
#include "device/probe.h"
#include <cmath>
#include <gtest/gtest.h>

namespace nacre::test {
namespace {

using namespace shared;

struct Case {
    float g, bleed;
    std::uint32_t reciprocal;
};

TEST(InfiniteMedium, SecondMoment) {
    constexpr std::uint32_t walks = 1 << 17;
    // Bleed below .25, or the square's own variance is infinite.
    for (const Case &c :
         {Case{0, 0, 0}, {-.9f, 0, 0}, {.8f, 0, 0}, {.95f, 0, 0}, {0, .1f, 0}, {.8f, .1f, 0}, {.8f, .1f, 1}})
        for (const std::uint32_t n : {1u, 3u, 20u}) {
            Probe probe;
            probe.anisotropy = c.g;
            probe.bleed = c.bleed;
            probe.reciprocal = c.reciprocal;
            probe.cap = n;
            probe.count = walks;
            probe.seed = n;
            const std::vector<float> ends = run_probe("probe_infinite", probe, walks, 4);
            double sum = 0, squares = 0;
            for (std::size_t i = 0; i < walks; ++i) {
                const double x = ends[4 * i], y = ends[4 * i + 1], z = ends[4 * i + 2], r2 = x * x + y * y + z * z;
                sum += r2;
                squares += r2 * r2;
            }
            const double mean = sum / walks, error = std::sqrt((squares / walks - mean * mean) / walks);
            // Moments of a power law with the exponent k of T: a / (k-1) and 2 a^2 / ((k-1)(k-2)).
            const auto moment = [&](std::uint32_t i, int order) {
                if (c.bleed == 0) return order == 1 ? 1.0 : 2.0;
                const double a = 1 / double(c.bleed), k = a + (c.reciprocal && i > 0 ? 1 : 0);
                return order == 1 ? a / (k - 1) : 2 * a * a / ((k - 1) * (k - 2));
            };
            double exact = 0;
            for (std::uint32_t i = 0; i < n; ++i) {
                exact += moment(i, 2);
                for (std::uint32_t j = i + 1; j < n; ++j)
                    exact += 2 * moment(i, 1) * moment(j, 1) * std::pow(double(c.g), j - i);
            }
            EXPECT_NEAR(mean, exact, 4 * error) << "g " << c.g << " bleed " << c.bleed << " n " << n;
            EXPECT_LT(error, .015 * exact);
        }
}

} // namespace
} // namespace nacre::test
