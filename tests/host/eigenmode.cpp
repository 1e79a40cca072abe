// The modes that guide walks: against transport theory, and that techniques made of them are normalised.
#include "guide/eigenmode.h"
#include "render/guides.h"
#include "scene/scene.h"
#include <cmath>
#include <numbers>

namespace nacre::guide {
namespace {

using namespace shared;

TEST(Eigenmode, IsotropicRoot) {
    for (const double albedo : {.4, .5, .8, .9, .99, .9999, 1 - 1e-6}) {
        const double nu = eigenmode(albedo, 0).nu;
        EXPECT_NEAR(albedo * nu / 2 * std::log1p(2 / (nu - 1)), 1, 1e-9) << albedo;
    }
}

TEST(Eigenmode, KnownRoot) { EXPECT_NEAR(eigenmode(.9, .8).nu, 3.78864715, 1e-8); }

// nu nears 1 / sqrt(3 (1 - albedo)(1 - albedo g)) as the albedo nears 1, by the order of (1 - albedo) / (1 - g^2).
TEST(Eigenmode, DiffusionLimit) {
    for (const double g : {-.98, -.5, 0., .5, .8, .95, .98})
        for (const double absorbed : {1e-4, 1e-6})
            EXPECT_NEAR(eigenmode(1 - absorbed, g).nu * std::sqrt(3 * absorbed * (1 - (1 - absorbed) * g)), 1,
                        absorbed / (1 - g * g))
                << "g " << g << " absorbed " << absorbed;
}

// The transport equation (1 - mu / nu) phi = albedo times the mean of phi over the phase function, by quadrature about
// the direction: nothing of the moments that phi was made of.
TEST(Eigenmode, SolvesTheTransportEquation) {
    constexpr int points = 400;
    for (const auto &[albedo, g] : {std::pair{.9, 0.}, {.9, .5}, {.8, -.5}, {.99, .8}}) {
        const Eigenmode mode = eigenmode(albedo, g);
        for (const double mu : {-1., -.4, .3, .9}) {
            double scattered = 0;
            for (int i = 0; i < points; ++i) {
                const double u = (2 * i + 1.) / points - 1, s = (1 - g * g) / (1 + g * u);
                const double cosine = g == 0 ? u : (1 + g * g - s * s) / (2 * g);
                const double across = std::sqrt((1 - cosine * cosine) * (1 - mu * mu));
                for (int j = 0; j < 64; ++j)
                    scattered +=
                        mode.phi(cosine * mu + across * std::cos(2 * std::numbers::pi * j / 64)) / (64 * points);
            }
            EXPECT_NEAR(albedo * scattered / ((1 - mu / mode.nu) * mode.phi(mu)), 1, 1e-4)
                << "albedo " << albedo << " g " << g << " mu " << mu;
        }
    }
}

double legendre_sum(const double *factors, double mu) {
    double sum = 0;
    for (unsigned l = 0; l < GUIDE_TERMS; ++l) sum += factors[l] * std::legendre(l, mu);
    return sum;
}

/// Points and weights of Gauss and Legendre in (-1, 1).
struct Gauss {
    std::vector<double> at, weight;

    explicit Gauss(unsigned count) {
        for (unsigned i = 0; i < count; ++i) {
            double x = std::cos(std::numbers::pi * (i + .75) / (count + .5)), slope = 0;
            for (int step = 0; step < 20; ++step) { // Newton's method
                slope = count * (x * std::legendre(count, x) - std::legendre(count - 1, x)) / (x * x - 1);
                x -= std::legendre(count, x) / slope;
            }
            at.push_back(x);
            weight.push_back(2 / ((1 - x * x) * slope * slope));
        }
    }
};

/// Integral of HG(w_i . w) phi(mu) over all w, w_i with the cosine `from`, from the device's numbers.
double integral(const double *phi, double g, double from) {
    static const Gauss gauss(128);
    constexpr int azimuths = 2 * GUIDE_TERMS; // exact: phi is a polynomial of the azimuth's cosine
    double sum = 0;
    for (std::size_t i = 0; i < gauss.at.size(); ++i) {
        // By Henyey & Greenstein's own distribution, u in (-1, 1).
        const double u = gauss.at[i], s = (1 - g * g) / (1 + g * u),
                     cosine = g == 0 ? u : (1 + g * g - s * s) / (2 * g);
        const double across = std::sqrt(std::max(0., (1 - cosine * cosine) * (1 - from * from)));
        for (int k = 0; k < azimuths; ++k) {
            const double mu = cosine * from + across * std::cos(2 * std::numbers::pi * (k + .5) / azimuths);
            sum += gauss.weight[i] / 2 / azimuths * legendre_sum(phi, mu);
        }
    }
    return sum;
}

void expect_normalised(const GuideMode &mode, float g, const std::string &what) {
    double phi[GUIDE_TERMS], scattered[GUIDE_TERMS];
    float power = 1;
    for (std::size_t l = 0; l < GUIDE_TERMS; ++l) { // as mode_load, in float
        phi[l] = double(mode.phi[l]);
        scattered[l] = double(power * mode.phi[l]);
        power *= g;
    }
    // Where |g| is large and the medium dark, the polynomials cancel and the rounding of their factors shows.
    double rounding = 0;
    for (std::size_t l = 0; l < GUIDE_TERMS; ++l) rounding += double(l) * 0x1p-24 * std::abs(scattered[l]);
    for (const double from : {-1., -.7, 0., .5, 1.}) {
        const double mean = legendre_sum(scattered, from);
        EXPECT_NEAR(integral(phi, double(g), from) / mean, 1, std::max(1e-6, rounding / mean))
            << what << " from " << from;
    }
    for (int i = 0; i <= 200; ++i) {
        const double value = legendre_sum(phi, .01 * i - 1);
        EXPECT_GT(value, 0) << what << " at " << .01 * i - 1;
        EXPECT_LE(value, double(mode.peak)) << what << " at " << .01 * i - 1;
    }
    EXPECT_GT(1 / double(mode.inverse_nu) - 1, 1e-4) << what;
}

std::vector<GuideMode> table(const scene::Value &anisotropy, Guiding guiding) {
    scene::Scene scene;
    scene.render.guiding = guiding;
    scene::Material &material = scene.materials.emplace_back();
    material[PARAMETER_subsurface_weight].value = Vec3::Ones();
    material[PARAMETER_subsurface_scatter_anisotropy] = anisotropy;
    std::vector<Material> materials(1);
    std::vector<GuideMode> modes;
    render::add_guides(scene, false, materials, modes);
    return modes;
}

TEST(GuideTable, EveryModeOfOnePhaseFunctionIsNormalised) {
    for (const double g : {-.98, -.5, 0., .5, .8, .95, .98}) {
        const std::vector<GuideMode> modes = table({Vec3::Constant(g)}, GUIDING_EIGEN);
        ASSERT_EQ(modes.size(), std::size_t(GUIDE_ALBEDOS));
        for (std::size_t i = 0; i < modes.size(); ++i)
            expect_normalised(modes[i], float(g), fmt::format("g {} mode {}", g, i));
    }
}

// A texture's anisotropy is seldom that of the mode: the technique is normalised all the same.
TEST(GuideTable, EveryModeOfAnyPhaseFunctionIsNormalised) {
    const std::vector<GuideMode> modes = table({Vec3::Zero(), 0}, GUIDING_EIGEN);
    ASSERT_EQ(modes.size(), std::size_t(GUIDE_ALBEDOS * (2 * GUIDE_ANISOTROPIES + 1)));
    for (std::size_t i = 0; i < modes.size(); ++i) {
        const double g = .98 * (double(i / GUIDE_ALBEDOS) / GUIDE_ANISOTROPIES - 1);
        expect_normalised(modes[i], float(i % 2 ? g : g * .97 + .01), fmt::format("g {} mode {}", g, i));
    }
}

// Eight polynomials hold phi of bright media; that of a dark one is a brighter medium's.
TEST(GuideTable, HoldsTheMode) {
    for (const double g : {-.5, 0., .5, .8, .95}) {
        const GuideMode mode = guide_mode(.99, g, false);
        const Eigenmode exact = eigenmode(.99, g);
        double phi[GUIDE_TERMS];
        std::copy(std::begin(mode.phi), std::end(mode.phi), phi);
        EXPECT_NEAR(1 / double(mode.inverse_nu), exact.nu, 1e-6 * exact.nu) << g;
        for (const double mu : {-1., -.5, 0., .5, 1.})
            EXPECT_NEAR(legendre_sum(phi, mu) / exact.phi(mu), 1, .1) << "g " << g << " mu " << mu;
    }
}

// Krivanek & d'Eon's direction, 1 / (2 pi spread (nu - mu)).
TEST(GuideTable, DwivediIsNormalised) {
    for (const GuideMode &mode : table({Vec3::Zero()}, GUIDING_DWIVEDI)) {
        const double nu = 1 / double(mode.inverse_nu);
        EXPECT_NEAR((std::log1p(1 / nu) - std::log1p(-1 / nu)) / double(mode.spread), 1, 1e-5) << nu;
    }
}

} // namespace
} // namespace nacre::guide
