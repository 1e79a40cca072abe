// What half-spaces return of light inside them, against what is known of it by other ways.
#include "albedo/returned.h"
#include "albedo/half_space.h"
#include "base/legendre.h"
#include "guide/eigenmode.h"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace nacre::albedo {
namespace {

using namespace shared;

double share(const Returned &returned, double depth, double cosine) {
    const Eigen::VectorXd moments = returned.moments(depth);
    return moments.dot(legendre(cosine, moments.size()));
}

/// Depth of a flight of renewal along its direction, from a number in (0, 1).
double flight(double bleed, double xi) { return bleed == 0 ? -std::log(xi) : (std::pow(xi, -bleed) - 1) / bleed; }

// Light that enters comes to its first scatter, and returns from there: together that is the colour, which the solver
// of half-spaces has to 1e-8 (5e-6 under bleed).
TEST(Returned, FirstScattersMakeTheColor) {
    const GaussNodes nodes = gauss_nodes(48);
    for (const double g : {-.5, 0., .8, .95})
        for (const double bleed : {0., .5, 1.})
            for (const double albedo : {.3, .9, .995}) {
                if (g == .95 && bleed > 0) continue;
                const Ordinates ordinates(g, bleed, FLIGHT_RENEWAL, bleed > 0 ? 8 : 32, 1e-6);
                const Returned returned(ordinates, g, albedo);
                double color = 0;
                for (Eigen::Index i = 0; i < 48; ++i)
                    for (Eigen::Index k = 0; k < 48; ++k) {
                        const double mu = nodes.point[i], depth = mu * flight(bleed, nodes.point[k]);
                        color += 2 * mu * nodes.weight[i] * nodes.weight[k] * albedo * share(returned, depth, -mu);
                    }
                EXPECT_NEAR(color, reflectance(albedo, g, bleed, FLIGHT_RENEWAL).lambert, 1e-4)
                    << "g " << g << ", bleed " << bleed << ", albedo " << albedo;
            }
}

// Deep down the share falls like the medium's slowest mode.
TEST(Returned, FallsLikeTheSlowestMode) {
    for (const double g : {0., .8})
        for (const double albedo : {.9, .99}) {
            const Returned returned(Ordinates(g, 0, FLIGHT_RENEWAL, 12, 1), g, albedo);
            const double nu = guide::eigenmode(albedo, g).nu, depth = 12 * nu;
            EXPECT_NEAR(share(returned, depth, .3) / share(returned, depth + nu, .3), std::numbers::e, 1e-4);
        }
}

/// Weight that a walk from a scatter brings out, of a slab through the side that depths count from. Henyey-Greenstein
/// by its inverse.
double walk(std::mt19937_64 &random, double albedo, double g, double bleed, FlightLaw law, double depth, double mu,
            double thickness = std::numeric_limits<double>::infinity()) {
    std::uniform_real_distribution<> unit(0, 1);
    constexpr double least = .1;
    const double rate = law == FLIGHT_RECIPROCAL ? 1 + bleed : 1;
    double weight = 1;
    for (;;) {
        const double xi = unit(random), f = (1 - g * g) / (1 - g + 2 * g * xi);
        const double cosine = g == 0 ? 2 * xi - 1 : (1 + g * g - f * f) / (2 * g);
        const double across = std::sqrt(std::max(0., (1 - cosine * cosine) * (1 - mu * mu)));
        mu = cosine * mu + across * std::cos(2 * std::numbers::pi * unit(random));
        depth -= mu * flight(bleed, std::pow(1 - unit(random), 1 / rate));
        if (depth < 0) return weight;
        if (depth > thickness) return 0;
        weight *= albedo;
        if (weight >= least) continue;
        if (unit(random) * least > weight) return 0;
        weight = least;
    }
}

// Within 4 standard errors of 1e5 walks, of some .001.
TEST(Returned, WhatWalksBringOut) {
    std::mt19937_64 random(1);
    for (const double g : {0., .8})
        for (const auto &[bleed, law] : {std::pair{0., FLIGHT_RENEWAL}, {1., FLIGHT_RENEWAL}, {.5, FLIGHT_RECIPROCAL}})
            for (const double albedo : {.6, .98}) {
                const Returned returned(Ordinates(g, bleed, law, bleed > 0 ? 8 : 12, 1e-6), g, albedo);
                for (const double depth : {.02, .5, 4.})
                    for (const double cosine : {-.8, .6}) {
                        constexpr int walks = 100000;
                        double sum = 0, squares = 0;
                        for (int i = 0; i < walks; ++i) {
                            const double w = walk(random, albedo, g, bleed, law, depth, cosine);
                            sum += w;
                            squares += w * w;
                        }
                        const double mean = sum / walks, error = std::sqrt((squares / walks - mean * mean) / walks);
                        EXPECT_NEAR(share(returned, depth, cosine), mean, 4 * error)
                            << "g " << g << ", bleed " << bleed << ", law " << law << ", albedo " << albedo
                            << ", depth " << depth << ", cosine " << cosine;
                    }
            }
}

// The same of slabs.
TEST(Returned, WhatWalksBringOutOfSlabs) {
    std::mt19937_64 random(1);
    for (const double g : {0., .8})
        for (const double bleed : {0., .5})
            for (const auto &[albedo, thickness] : {std::pair{.6, .5}, {.98, 4.}}) {
                const Ordinates ordinates(g, bleed, FLIGHT_RENEWAL, bleed > 0 ? 8 : 12, 1e-6);
                const Returned returned(ordinates, g, albedo, thickness);
                for (const double part : {.1, .5, .9})
                    for (const double cosine : {-.8, .6}) {
                        constexpr int walks = 100000;
                        double sum = 0, squares = 0;
                        for (int i = 0; i < walks; ++i) {
                            const double w =
                                walk(random, albedo, g, bleed, FLIGHT_RENEWAL, part * thickness, cosine, thickness);
                            sum += w;
                            squares += w * w;
                        }
                        const double mean = sum / walks, error = std::sqrt((squares / walks - mean * mean) / walks);
                        EXPECT_NEAR(share(returned, part * thickness, cosine), mean, 4 * error)
                            << "g " << g << ", bleed " << bleed << ", albedo " << albedo << ", part " << part
                            << ", cosine " << cosine;
                    }
            }
}

// Black slabs let through 2 E_3, white ones all that they do not reflect, thick ones reflect what half-spaces do.
TEST(Returned, SlabsReflectAndTransmit) {
    for (const auto &[thickness, wanted] : {std::pair{.1, .8325829}, {1., .2193839}, {4., .0055227}}) // 2 E_3
        EXPECT_NEAR(Returned(Ordinates(0, 0, FLIGHT_RENEWAL, 24, 1), 0, 1e-9, thickness).transmitted(), wanted, 1e-5);
    for (const double g : {0., .8}) {
        const Ordinates ordinates(g, 0, FLIGHT_RENEWAL, 24, 1);
        for (const double thickness : {.1, 3., 50.}) {
            const Returned white(ordinates, g, 1 - 1e-9, thickness);
            EXPECT_NEAR(white.reflected() + white.transmitted(), 1, 1e-5);
        }
        EXPECT_NEAR(Returned(ordinates, g, .9, 300).reflected(), reflectance(.9, g, 0, FLIGHT_RENEWAL).lambert, 1e-6);
        EXPECT_NEAR(Returned(ordinates, g, .9).reflected(), reflectance(.9, g, 0, FLIGHT_RENEWAL).lambert, 1e-6);
    }
}

} // namespace
} // namespace nacre::albedo
