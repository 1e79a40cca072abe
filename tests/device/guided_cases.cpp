#include "device/guided_cases.h"
#include <gtest/gtest.h>
#include <map>
#include <random>

namespace nacre::test {
namespace {

using namespace shared;

enum Factor { guiding, sampling, law, anisotropy, bleed, entry, body, factors };
constexpr int levels[factors] = {3, 4, 2, 6, 3, 2, 4};
using Row = std::array<int, factors>;

constexpr float4 anisotropies[] = {
    {-.5f, -.5f, -.5f, 0}, {}, {.5f, .5f, .5f, 0}, {.8f, .8f, .8f, 0}, {.95f, .95f, .95f, 0}, {.9f, .8f, .5f, 0}};
constexpr float bleeds[] = {0, .5f, 1};
constexpr float thicknesses[] = {0, 1, 5, -3}; // half-space, slabs, sphere

bool grey(const Row &row) { return row[sampling] == CHANNEL_SINGLE || row[sampling] == CHANNEL_ALBEDO; }

bool allowed(const Row &row) {
    if (row[guiding] == GUIDING_DWIVEDI && row[anisotropy] != 1) return false;
    return !(grey(row) && row[anisotropy] == 5);
}

GuidedCase case_of(const Row &row, std::uint32_t number) {
    GuidedCase c{Guiding(row[guiding]), ChannelSampling(row[sampling]), {}};
    Probe &probe = c.probe;
    probe.sigma = grey(row) ? float4{1, 1, 1, 0} : float4{1, 2.857142857f, 5, 0};
    probe.albedo = grey(row) && c.guiding != GUIDING_NONE ? float4{.9f, .9f, .9f, 0} : float4{.95f, .9f, .6f, 0};
    probe.walk_anisotropy = anisotropies[row[anisotropy]];
    probe.walk_anisotropy.w = 1; // as it is, g = 0 too
    probe.anisotropy = probe.walk_anisotropy.x;
    probe.bleed = bleeds[row[bleed]];
    probe.reciprocal = std::uint32_t(row[law]);
    probe.entry = std::uint32_t(row[entry]);
    probe.thickness = thicknesses[row[body]];
    probe.seed = 1000 * (number + 1);
    return c;
}

std::vector<Row> rows(int count) {
    std::mt19937 random(7);
    std::map<std::array<int, 4>, int> seen; // factors and levels of a pair
    std::vector<Row> chosen;
    while (int(chosen.size()) < count) {
        Row best{};
        double most = -1;
        for (int candidate = 0; candidate < 64; ++candidate) {
            Row row;
            for (int f = 0; f < factors; ++f) row[std::size_t(f)] = int(random() % std::uint32_t(levels[f]));
            if (!allowed(row)) continue;
            double rare = 0;
            for (int a = 0; a < factors; ++a)
                for (int b = 0; b < a; ++b)
                    rare += 1 / (1.0 + 4 * seen[{a, b, row[std::size_t(a)], row[std::size_t(b)]}]);
            if (rare > most) most = rare, best = row;
        }
        for (int a = 0; a < factors; ++a)
            for (int b = 0; b < a; ++b) ++seen[{a, b, best[std::size_t(a)], best[std::size_t(b)]}];
        chosen.push_back(best);
    }
    return chosen;
}

TEST(GuidedCases, ThirtyHaveEveryValueAndTwoHundredEveryPair) {
    std::set<std::array<int, 2>> values;
    for (const Row &row : rows(30)) {
        EXPECT_TRUE(allowed(row));
        for (int f = 0; f < factors; ++f) values.insert({f, row[std::size_t(f)]});
    }
    EXPECT_EQ(values.size(), 3 + 4 + 2 + 6 + 3 + 2 + 4);
    std::set<std::array<int, 4>> pairs;
    for (const Row &row : rows(200))
        for (int a = 0; a < factors; ++a)
            for (int b = 0; b < a; ++b) pairs.insert({a, b, row[std::size_t(a)], row[std::size_t(b)]});
    // (24^2 - (9 + 16 + 4 + 36 + 9 + 4 + 16)) / 2 less what is not allowed: dwivedi with 5 anisotropies, and the
    // anisotropy that differs between channels with `single` and `albedo`.
    EXPECT_EQ(pairs.size(), (24 * 24 - 94) / 2 - 5 - 2);
}

} // namespace

std::string name_of(const GuidedCase &c) {
    static const char *const guidings[] = {"none", "dwivedi", "eigen"};
    static const char *const samplings[] = {"single", "albedo", "throughput", "hero"};
    const float4 g = c.probe.walk_anisotropy;
    return fmt::format("{} {} {} g {}/{}/{} bleed {} {} thickness {}", guidings[c.guiding], samplings[c.sampling],
                       c.probe.reciprocal ? "reciprocal" : "renewal", g.x, g.y, g.z, c.probe.bleed,
                       c.probe.entry == ENTRY_UNIFORM ? "uniform" : "lambert", c.probe.thickness);
}

std::vector<GuidedCase> guided_cases(int count) {
    std::vector<GuidedCase> cases;
    for (const Row &row : rows(count)) cases.push_back(case_of(row, std::uint32_t(cases.size())));
    return cases;
}

} // namespace nacre::test
