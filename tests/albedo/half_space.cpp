// The solver of half-spaces, against values known to eight digits and more, and its methods against one another.
#include "albedo/half_space.h"
#include "albedo/isotropic.h"
#include "oracle/adding_doubling.h"
#include <cmath>
#include <gtest/gtest.h>

namespace nacre::albedo {
namespace {

using namespace shared;

// H-functions in float64, lambert entry.
TEST(HalfSpace, Isotropic) {
    const struct {
        double albedo, bleed, color;
    } known[] = {{.5, 0, .1465443807},  {.5, .5, .1496789652},  {.5, 1, .1524930237},
                 {.9, 0, .4780244892},  {.9, .5, .4832079736},  {.9, 1, .4883614567},
                 {.99, 0, .7945636529}, {.99, .5, .7972926908}, {.99, 1, .8005208025}};
    for (const auto &k : known)
        EXPECT_NEAR(reflectance(k.albedo, 0, k.bleed, FLIGHT_RENEWAL).lambert, k.color, 1e-7)
            << "albedo " << k.albedo << ", bleed " << k.bleed;
}

// Uniform entry, g = 0: (1 - r) / (1 + r), r = sqrt(1 - albedo), whatever the law that all flights share (Sparre
// Andersen 1954). By H-function, by modes and by imbedding.
TEST(HalfSpace, UniversalLaw) {
    for (const double bleed : {0., .01, .5, 1., 2., 4.})
        for (const double albedo : {.1, .5, .9, .99}) {
            const double r = std::sqrt(1 - albedo), exact = (1 - r) / (1 + r);
            EXPECT_NEAR(reflectance_isotropic(albedo, bleed, FLIGHT_RENEWAL).uniform, exact, 5e-9);
            EXPECT_NEAR(reflectance_by_modes(Ordinates(0, bleed, FLIGHT_RENEWAL, 6, 1e-9), albedo).uniform, exact,
                        2e-5);
            Eigen::MatrixXd moments;
            EXPECT_NEAR(reflectance_by_imbedding(Ordinates(0, bleed, FLIGHT_RENEWAL, 6, 0), albedo, moments).uniform,
                        exact, 1e-7);
        }
}

// physics notes, section 4: .466, .417, .340.
TEST(HalfSpace, ReciprocalFlights) {
    const std::pair<double, double> known[] = {{.5, .466}, {1, .417}, {2, .340}};
    for (const auto &[bleed, color] : known)
        EXPECT_NEAR(reflectance(.9, 0, bleed, FLIGHT_RECIPROCAL).uniform, color, 5e-4);
}

TEST(HalfSpace, ForwardScattering) {
    const struct {
        double albedo, g, color;
    } known[] = {{.9, .5, .36015164}, {.9, .8, .21672348}, {.9, .9, .13258493}, {.99, .8, .60264779}};
    for (const auto &k : known) EXPECT_NEAR(reflectance(k.albedo, k.g, 0, FLIGHT_RENEWAL).lambert, k.color, 1e-6);
    EXPECT_NEAR(reflectance(.9, .8, .5, FLIGHT_RENEWAL).lambert, .221501, 1e-5);
    for (const double g : {-.9, -.3, .3}) // and another method, of layers
        EXPECT_NEAR(reflectance(.95, g, 0, FLIGHT_RENEWAL).lambert, test::half_space_reflectance(.95, g), 2e-6);
}

// Eigen's BDCSVD gives wrong vectors here: .18348.
TEST(HalfSpace, WhereFastModesFail) {
    const double g = -.9 + 1.85 * 4 / 10, albedo = albedo_of(std::pow(.818667, 5), g);
    EXPECT_NEAR(reflectance(albedo, g, 4, FLIGHT_RECIPROCAL).lambert, .17393762, 1e-6);
}

// Where both hold, they agree: they share nodes and nothing else.
TEST(HalfSpace, ModesAndImbedding) {
    for (const double bleed : {.3, 1.})
        for (const double g : {-.5, .8, .95})
            for (const FlightLaw law : {FLIGHT_RENEWAL, FLIGHT_RECIPROCAL}) {
                const Ordinates ordinates(g, bleed, law, 6, 1e-9);
                Eigen::MatrixXd moments;
                const Reflectance modes = reflectance_by_modes(ordinates, .95);
                const Reflectance imbedded = reflectance_by_imbedding(ordinates, .95, moments);
                EXPECT_NEAR(modes.lambert, imbedded.lambert, 1e-7) << "g " << g << ", bleed " << bleed;
                EXPECT_NEAR(modes.uniform, imbedded.uniform, 1e-7) << "g " << g << ", bleed " << bleed;
            }
}

// Between its nodes, and what comes of twice the cosines, a curve is as exact as half_space.h says.
TEST(HalfSpace, CurveBetweenNodes) {
    for (const auto &[g, bleed, law] : {std::tuple(.8, 0., FLIGHT_RENEWAL),
                                        {.5, .5, FLIGHT_RENEWAL},
                                        {.8, 1., FLIGHT_RECIPROCAL},
                                        {.3, 3., FLIGHT_RENEWAL}}) {
        const HalfSpace medium(g, bleed, law);
        for (const double s : {.15, .4, .7}) {
            const Reflectance exact = reflectance(albedo_of(s, g), g, bleed, law);
            EXPECT_NEAR(medium.color(s, ENTRY_LAMBERT), exact.lambert, 1e-5);
            EXPECT_NEAR(medium.color(s, ENTRY_UNIFORM), exact.uniform, 2e-5);
            EXPECT_NEAR(medium.similarity(medium.color(s, ENTRY_LAMBERT), ENTRY_LAMBERT), s, 1e-9);
        }
        EXPECT_EQ(medium.color(0, ENTRY_LAMBERT), 1);
        EXPECT_NEAR(medium.color(1, ENTRY_LAMBERT), 0, 1e-12);
    }
}

// Near white reciprocal flights of a bleed above 1 go like 1 - s^(2 / (1 + bleed)), not like a polynomial: H-functions,
// which hold for any similarity, say how well this is met, and the modes elsewhere.
TEST(HalfSpace, ReciprocalCurveNearWhite) {
    for (const double bleed : {.5, 1.3, 2., 4.}) {
        const HalfSpace isotropic(0, bleed, FLIGHT_RECIPROCAL);
        for (const double s : {1e-6, 1e-5, 1e-4, 1e-3, .03})
            EXPECT_NEAR(isotropic.color(s, ENTRY_LAMBERT),
                        reflectance(albedo_of(s, 0), 0, bleed, FLIGHT_RECIPROCAL).lambert, 1e-5)
                << "bleed " << bleed << ", similarity " << s;
    }
    const HalfSpace medium(-.95, 2, FLIGHT_RECIPROCAL);
    for (const double s : {1e-3, .03, .24})
        EXPECT_NEAR(medium.color(s, ENTRY_LAMBERT), reflectance(albedo_of(s, -.95), -.95, 2, FLIGHT_RECIPROCAL).lambert,
                    1e-6)
            << "similarity " << s;
}

} // namespace
} // namespace nacre::albedo
