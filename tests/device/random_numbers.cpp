// Hashed numbers are uniform, alone and in pairs, within one call and from call to call.
#include "device/chi_square.h"
#include "device/probe.h"
#include <cmath>
#include <gtest/gtest.h>

namespace nacre::test {
namespace {

constexpr std::uint32_t samples = 1 << 20;

std::vector<double> column(const std::vector<float> &values, std::size_t at, std::size_t shift = 0) {
    std::vector<double> result(samples);
    for (std::size_t i = 0; i < samples; ++i) result[i] = values[(i + shift) % samples * 4 + at];
    return result;
}

/// The last of the 23 bits, as a number: they are the worst of hashes that multiply.
std::vector<double> last_bits(std::vector<double> numbers) {
    for (double &x : numbers) x = x * 65536 - std::floor(x * 65536);
    return numbers;
}

TEST(RandomHash, UniformAloneAndInPairs) {
    for (const std::uint32_t seed : {0u, 1u, 0xffffffffu})
        for (const std::uint32_t third : {0u, 12345u}) {
            Probe probe;
            probe.seed = seed;
            probe.first = third;
            probe.count = samples;
            const std::vector<float> values = run_probe("probe_hash", probe, samples, 4);
            for (const float value : values) ASSERT_TRUE(value > 0 && value < 1);
            const std::string what = "seed " + std::to_string(seed) + " word " + std::to_string(third) + ", ";
            for (std::size_t a = 0; a < 4; ++a) {
                expect_uniform(column(values, a), 1000, what + std::to_string(a));
                expect_distribution(pairs_in_bins(last_bits(column(values, a)), last_bits(column(values, a, 1)), 64),
                                    std::vector<double>(64 * 64, 1), what + "last bits"); // 128 numbers
                for (std::size_t b = a + 1; b < 4; ++b)
                    expect_uniform(column(values, a), column(values, b), 64,
                                   what + std::to_string(a) + " and " + std::to_string(b));
                expect_uniform(column(values, a), column(values, a, 1), 64, what + "next to each other");
            }
        }
}

// Seeds one apart are as different as any.
TEST(RandomHash, NeighbouringSeeds) {
    Probe probe;
    probe.count = samples;
    probe.seed = 5;
    const std::vector<float> five = run_probe("probe_hash", probe, samples, 4);
    probe.seed = 6;
    const std::vector<float> six = run_probe("probe_hash", probe, samples, 4);
    for (std::size_t a = 0; a < 4; ++a) expect_uniform(column(five, a), column(six, a), 64, "seeds 5 and 6");
}

} // namespace
} // namespace nacre::test
