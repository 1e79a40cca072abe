// Inversions: the table against the solver, its ends, and what the others are off by.
#include "albedo/inversion.h"
#include "albedo/half_space.h"
#include "albedo/memo.h"
#include "albedo/table.h"
#include "base/parallel.h"
#include <cmath>
#include <gtest/gtest.h>
#include <mutex>
#include <random>
#include <tuple>

namespace nacre::albedo {
namespace {

using namespace shared;

struct Error {
    double largest = 0, sum = 0;
    int count = 0;
};

/// Where the table's nodes are far apart, at its ends, or both: g and bleed.
constexpr std::pair<double, double> corners[] = {{.95, 4},  {.972, 3.6}, {.98, 4},  {.98, 1.4}, {.95, 2},  {.965, 1.4},
                                                 {-.95, 4}, {-.93, 1.4}, {.972, 2}, {.6, .015}, {-.95, 0}, {.98, 0}};

/// Colours that come out, less those that were asked for: media of random g and bleed, `colors` in each, and in those
/// of the corners.
Error round_trip(std::size_t media, int colors) {
    Error all;
    std::mutex guard;
    parallel_for(media, [&](std::size_t k) {
        std::mt19937 random(unsigned(k) + 1);
        std::uniform_real_distribution<> uniform;
        double g = least_anisotropy + (largest_anisotropy - least_anisotropy) * uniform(random);
        double bleed = k % 4 == 0 ? 0 : largest_bleed * uniform(random) * uniform(random);
        const auto law = k % 2 ? FLIGHT_RECIPROCAL : FLIGHT_RENEWAL;
        if (k / 2 < std::size(corners)) std::tie(g, bleed) = corners[k / 2];
        const HalfSpace medium(g, bleed, law);
        for (int i = 0; i < colors; ++i) {
            const double x = uniform(random);
            // Not by the albedo: at a bleed of 4 colours above .999 have one that no double tells from 1.
            const double s = table_similarity(built_in_table(), x, g, bleed, law, ENTRY_LAMBERT);
            const double error = std::abs(medium.color(s, ENTRY_LAMBERT) - x);
            const std::lock_guard lock(guard);
            EXPECT_EQ(albedo(INVERSION_TABLE, x, {.anisotropy = g, .bleed = bleed, .flight = law}), albedo_of(s, g));
            EXPECT_LT(error, 2e-4) << "color " << x << ", g " << g << ", bleed " << bleed << ", law " << law;
            all.largest = std::max(all.largest, error);
            all.sum += error;
            ++all.count;
        }
    });
    return all;
}

void expect_exact(const Error &error) {
    EXPECT_GE(error.count, 20000);
    EXPECT_LT(error.sum / error.count, 2e-5);
    printf("[ round trip ] %d colours, at most %.1e, %.1e in the mean\n", error.count, error.largest,
           error.sum / error.count);
}

TEST(Inversion, RoundTrip) { expect_exact(round_trip(2 * std::size(corners) + 8, 650)); }
TEST(LongInversion, RoundTrip) { expect_exact(round_trip(600, 100)); }

TEST(Inversion, EndsAndOrder) {
    for (const double g : {-.999, -.95, 0., .7, .98, .999})
        for (const double bleed : {0., .3, 1., 4., 100.})
            for (const auto law : {FLIGHT_RENEWAL, FLIGHT_RECIPROCAL})
                for (const auto entry : {ENTRY_LAMBERT, ENTRY_UNIFORM, ENTRY_REFRACTED}) {
                    const Medium medium{g, bleed, law, entry};
                    EXPECT_EQ(albedo(INVERSION_TABLE, 0, medium), 0);
                    EXPECT_EQ(albedo(INVERSION_TABLE, 1, medium), 1);
                    double last = 0;
                    for (int i = 0; i <= 1000; ++i) {
                        const double a = albedo(INVERSION_TABLE, i / 1000., medium);
                        ASSERT_GE(a, last) << "color " << i / 1000. << ", g " << g << ", bleed " << bleed;
                        ASSERT_LE(a, 1);
                        last = a;
                    }
                }
}

/// Largest and mean error in colour over colours in [.002, .999] and g in [least, most].
Error error_of(const std::function<double(double, double)> &albedo_for, double least, double most) {
    Error all;
    for (int i = 0; i <= 8; ++i) {
        const double g = least + (most - least) * i / 8;
        const HalfSpace medium(g, 0, FLIGHT_RENEWAL);
        for (int j = 0; j <= 200; ++j) {
            const double x = .002 + .997 * j / 200, a = std::clamp(albedo_for(x, g), 0., 1.);
            const double error = std::abs(medium.color(std::sqrt((1 - a) / (1 - g * a)), ENTRY_LAMBERT) - x);
            all.largest = std::max(all.largest, error);
            all.sum += error;
            ++all.count;
        }
    }
    return all;
}

// physics notes, section 3: what other inversions are off by (bleed 0).
TEST(Inversion, OthersAreOffAsMeasured) {
    const auto by = [](Inversion inversion) {
        return [inversion](double x, double g) { return albedo(inversion, x, {.anisotropy = g}); };
    };
    const Error hulst = error_of(by(INVERSION_VAN_DE_HULST), -.9, .95);
    EXPECT_NEAR(hulst.largest, .0269, .002);
    EXPECT_NEAR(hulst.sum / hulst.count, .0022, .001);
    EXPECT_NEAR(error_of(by(INVERSION_CHIANG), 0, 0).largest, .073, .002);
    const Error published = error_of([](double x, double g) { return memo_albedo(published_fit, x, g); }, 0, .95);
    EXPECT_NEAR(published.largest, .294, .02);
    const Error ours = error_of(by(INVERSION_MEMO), 0, .95);
    EXPECT_LT(ours.largest, .006);
    EXPECT_LT(ours.sum / ours.count, .0006);
    EXPECT_EQ(albedo(INVERSION_NONE, .3, {.anisotropy = .8}), .3);
}

// A table is what it says it is, or it is refused.
TEST(Inversion, TableFile) {
    const std::vector<float> table(built_in_table().begin(), built_in_table().end());
    const std::string file = table_file(table);
    EXPECT_LT(file.size(), 200000u);
    EXPECT_EQ(read_table(file), table);
    EXPECT_THROW(read_table(file.substr(1)), std::runtime_error);
    EXPECT_THROW(read_table("nonsense"), std::runtime_error);
}

} // namespace
} // namespace nacre::albedo
