// Scrambling and shuffling leave a (0,2)-sequence in base 2 what it is: of its first 2^k samples, and of every aligned
// 2^k after them, exactly one lies in each elementary interval (2^-i by 2^-(k-i)).
#include "device/chi_square.h"
#include "device/probe.h"
#include <gtest/gtest.h>
#include <set>

namespace nacre::test {
namespace {

std::vector<float> pairs(std::uint32_t key, std::uint32_t dimension, std::uint32_t count) {
    Probe probe;
    probe.seed = key;
    probe.entry = dimension;
    probe.count = count;
    return run_probe("probe_sobol", probe, count, 2);
}

TEST(Sobol, OnePointInEveryElementaryInterval) {
    for (const std::uint32_t key : {0u, 1u, 77u, 0xdeadbeefu})
        for (const std::uint32_t dimension : {0u, 5u, 38u}) {
            const std::vector<float> points = pairs(key, dimension, 2048);
            for (const float x : points) ASSERT_TRUE(x > 0 && x < 1);
            for (std::uint32_t k = 0; k <= 10; ++k)
                for (std::uint32_t block = 0; block < (2048u >> k); ++block)
                    for (std::uint32_t i = 0; i <= k; ++i) {
                        std::vector<int> hits(1u << k);
                        for (std::uint32_t s = block << k; s < (block + 1) << k; ++s) {
                            const auto x = std::uint32_t(points[2 * s] * float(1u << i));
                            const auto y = std::uint32_t(points[2 * s + 1] * float(1u << (k - i)));
                            ++hits[(y << i) + x];
                        }
                        for (const int hit : hits)
                            ASSERT_EQ(hit, 1) << "key " << key << ", dimension " << dimension << ", block " << block
                                              << " of 2^" << k << ", 2^-" << i << " wide";
                    }
        }
}

// The same of 2^18 samples: the upper half of the second dimension's matrix matters only after 65,536 of them.
TEST(Sobol, FarIntoTheSequence) {
    constexpr std::uint32_t k = 18;
    const std::vector<float> points = pairs(3, 2, 1u << k);
    for (std::uint32_t i = 0; i <= k; ++i) {
        std::vector<bool> hit(1u << k);
        for (std::uint32_t s = 0; s < 1u << k; ++s) {
            const auto x = std::uint32_t(points[2 * s] * float(1u << i));
            const auto y = std::uint32_t(points[2 * s + 1] * float(1u << (k - i)));
            ASSERT_FALSE(hit[(y << i) + x]) << "2^-" << i << " wide, sample " << s;
            hit[(y << i) + x] = true;
        }
    }
}

// Over keys (pixels, seeds) each single sample is uniform, the first too: estimates of pixels are unbiased.
TEST(Sobol, EverySampleIsUniformOverKeys) {
    constexpr std::uint32_t keys = 1 << 20, samples = 4;
    Probe probe;
    probe.entry = 3;
    probe.first = samples;
    probe.count = keys * samples;
    const std::vector<float> points = run_probe("probe_sobol", probe, probe.count, 2);
    for (std::size_t s = 0; s < samples; ++s) {
        std::vector<double> x(keys), y(keys);
        for (std::size_t key = 0; key < keys; ++key) {
            x[key] = points[2 * (key * samples + s)];
            y[key] = points[2 * (key * samples + s) + 1];
        }
        expect_uniform(x, y, 64, "sample " + std::to_string(s));
    }
}

// Pairs of different names must not be the same points.
TEST(Sobol, DimensionsDiffer) {
    std::set<std::vector<float>> all;
    for (std::uint32_t dimension = 0; dimension < 39; ++dimension) all.insert(pairs(9, dimension, 64));
    EXPECT_EQ(all.size(), 39u);
}

} // namespace
} // namespace nacre::test
