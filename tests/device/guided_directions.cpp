// Guided walks turn as their density says, and the density is the one of the medium's mode.
#include "device/buffer.h"
#include "device/chi_square.h"
#include "device/directions.h"
#include "guide/eigenmode.h"
#include "shared/features.h"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace nacre::test {
namespace {

using namespace shared;

constexpr std::uint32_t samples = 1 << 20;
constexpr double guide_share = 0.75; // the test's own

/// A scatter in a slab whose near side is z = 0.
struct Scatter {
    double albedo, g;
    Vec3f from{0, 0, 1};
    float depth = 0, thickness = 1e9f, far_light = 1;
};

std::string name_of(const Scatter &s) {
    return fmt::format("albedo {} g {} from z {} depth {} of {} light {}", s.albedo, s.g, s.from.z(), s.depth,
                       s.thickness, s.far_light);
}

/// Directions, and their densities over the phase function.
std::vector<float> turns(const Scatter &scatter, const GuideMode &mode, Guiding guiding, std::uint32_t seed) {
    static const auto *const device = new device::Device(device::open_device());
    device::Variant variant;
    variant.entry = "probe_guide.cl";
    variant.features = FEATURE_SUBSURFACE | (scatter.g != 0 ? FEATURE_ANISOTROPY : 0) |
                       (guiding == GUIDING_EIGEN ? FEATURE_GUIDE_EIGEN : FEATURE_GUIDE_DWIVEDI);
    variant.extra = fmt::format("-DGUIDE_SHARE={}f", guide_share);
    Frame frame{};
    frame.features = variant.features;
    frame.channel_sampling = CHANNEL_HERO;
    const cl::Buffer frames = device::constant_buffer(*device, &frame, sizeof frame);
    const cl::Buffer modes = device::constant_buffer(*device, &mode, sizeof mode);
    const cl::Buffer out(device->context, CL_MEM_WRITE_ONLY, samples * sizeof(float4));
    cl::Kernel kernel(device::build(*device, variant).program, "probe_turn");
    kernel.setArg(0, frames);
    kernel.setArg(1, modes);
    kernel.setArg(2, float4{scatter.from.x(), scatter.from.y(), scatter.from.z(), 0});
    kernel.setArg(3, float4{scatter.depth, scatter.thickness, scatter.far_light, float(scatter.g)});
    kernel.setArg(4, seed);
    kernel.setArg(5, samples);
    kernel.setArg(6, out);
    const std::size_t group = std::size_t(device->quirks.work_group);
    device->queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange((samples + group - 1) / group * group),
                                       cl::NDRange(group));
    std::vector<float> values(std::size_t(samples) * 4);
    device->queue.enqueueReadBuffer(out, true, 0, values.size() * sizeof(float), values.data());
    return values;
}

double legendre_sum(const GuideMode &mode, double mu, double g) {
    double sum = double(mode.phi[0]), power = 1, p = 1, last = 0;
    for (int l = 1; l < GUIDE_TERMS; ++l) {
        const double next = ((2 * l - 1) * mu * p - (l - 1) * last) / l;
        last = std::exchange(p, next);
        power *= g;
        sum += double(mode.phi[l]) * power * p;
    }
    return sum;
}

/// physics.md section 6, in double: density of a direction with the cosine mu towards the near side, over the phase
/// function.
double density(const Scatter &scatter, const GuideMode &mode, double mu) {
    const double inverse_nu = double(mode.inverse_nu),
                 folds = double(2 * scatter.depth - scatter.thickness) * inverse_nu;
    const double far = folds > -20 ? double(scatter.far_light) * std::exp(std::min(folds, 20.)) : 0;
    if (scatter.g == 0) { // the phase function is 1 / (4 pi), phi is 1 / (nu - mu): both schemes turn alike
        const double near_pdf = 2 * inverse_nu / (double(mode.spread) * (1 - mu * inverse_nu));
        const double far_pdf = 2 * inverse_nu / (double(mode.spread) * (1 + mu * inverse_nu));
        return 1 - guide_share + guide_share * (near_pdf + far * far_pdf) / (1 + far);
    }
    const double from = -double(scatter.from.z());
    const double mean = legendre_sum(mode, from, scatter.g) + far * legendre_sum(mode, -from, scatter.g);
    return 1 - guide_share + guide_share * (legendre_sum(mode, mu, 1) + far * legendre_sum(mode, -mu, 1)) / mean;
}

/// Part of Henyey & Greenstein's function that is deflected further than to `cosine`, given 1 - cosine.
double cumulated(double away, double g) {
    if (g == 0) return 1 - away / 2;
    const double s = std::sqrt((1 - g) * (1 - g) + 2 * g * away);
    return .5 + .5 * ((1 - g) * (1 + g) / s - 1) / g;
}

constexpr std::size_t bins = 24; // of the part and of the azimuth: there the phase function is uniform

/// Integral over the directions of bin i of the part: by s = sqrt(1 + g^2 - 2 g cosine), in which they are spread
/// evenly.
template <typename Function> double integral(std::size_t i, double g, const Function &function) {
    constexpr int points = 24;
    const auto s_of = [&](double part) { return (1 - g * g) / (1 + g * (2 * part - 1)); };
    const double first = s_of(double(i) / bins), last = s_of(double(i + 1) / bins);
    double sum = 0;
    for (int k = 0; k < points; ++k) {
        const double at = (k + .5) / points, s = first + (last - first) * at;
        const double cosine = g == 0 ? 2 * (double(i) + at) / bins - 1 : (1 + g * g - s * s) / (2 * g);
        const double share = g == 0 ? 1. / bins : (1 - g * g) / (2 * g) * (first - last) / (s * s);
        sum += share / points * function(cosine);
    }
    return sum;
}

std::vector<double> expected(const Scatter &scatter, const GuideMode &mode) {
    constexpr std::size_t turns_per_bin = 8;
    const Vec3 axis = scatter.from.cast<double>();
    const Vec3 side = axis.cross(std::abs(axis.x()) < .7 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)).normalized();
    const Vec3 other = axis.cross(side);
    std::vector<double> shares(bins * bins);
    for (std::size_t i = 0; i < bins; ++i)
        for (std::size_t j = 0; j < bins * turns_per_bin; ++j) {
            const double turn = 2 * std::numbers::pi * (double(j) + .5) / (bins * turns_per_bin);
            const double across = std::cos(turn) * side.z() + std::sin(turn) * other.z();
            shares[i * bins + j / turns_per_bin] +=
                integral(i, scatter.g,
                         [&](double cosine) {
                             const double sine = std::sqrt(std::max(0., 1 - cosine * cosine));
                             return density(scatter, mode, -(cosine * axis.z() + sine * across));
                         }) /
                (bins * turns_per_bin);
        }
    return shares;
}

std::size_t bin_of(double u) { return std::size_t(std::clamp(u * bins, 0., bins - .5)); }

void check(const Scatter &scatter, Guiding guiding, std::uint32_t seed) {
    const GuideMode mode = guide::guide_mode(scatter.albedo, scatter.g, scatter.g == 0);
    const std::vector<float> drawn = turns(scatter, mode, guiding, seed);
    const Vec3 axis = scatter.from.cast<double>();
    std::vector<std::uint64_t> observed(bins * bins);
    double worst = 0;
    for (std::size_t i = 0; i < samples; ++i) {
        const Vec3 d = direction_of(drawn, i);
        ++observed[bin_of(cumulated(.5 * (d - axis).squaredNorm(), scatter.g)) * bins + bin_of(azimuth(d, axis))];
        if (i % 16 != 0) continue;
        worst = std::max(worst, std::abs(double(drawn[4 * i + 3]) / density(scatter, mode, -d.z()) - 1));
    }
    const std::vector<double> shares = expected(scatter, mode);
    EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.), 1, 1e-3) << name_of(scatter);
    EXPECT_LE(worst, 2e-5) << name_of(scatter);
    expect_distribution(observed, shares, name_of(scatter));
}

const Vec3f up(0, 0, -1), down(0, 0, 1), aslant = Vec3f(1, -2, -.5f).normalized(), level(1, 0, 0);

TEST(GuidedDirections, Eigen) {
    std::uint32_t seed = 1;
    for (const double g : {-.5, 0., .5, .8, .95})
        for (const Vec3f &from : {up, down, aslant, level})
            check({.albedo = .9, .g = g, .from = from}, GUIDING_EIGEN, ++seed);
}

TEST(GuidedDirections, EigenToBothSides) {
    std::uint32_t seed = 41;
    for (const float depth : {0.f, .3f, .5f, 1.f})
        check({.albedo = .95, .g = .8, .from = aslant, .depth = depth, .thickness = 1}, GUIDING_EIGEN, ++seed);
    check({.albedo = .95, .g = .8, .from = aslant, .depth = .5, .thickness = 5, .far_light = 20}, GUIDING_EIGEN,
          ++seed);
    check({.albedo = .95, .g = 0, .from = down, .depth = 2, .thickness = 2, .far_light = .05f}, GUIDING_EIGEN, ++seed);
}

TEST(GuidedDirections, EigenExtremes) {
    std::uint32_t seed = 61;
    for (const double albedo : {.01, .4, .999999, 1.})
        for (const double g : {-.98, 0., .98})
            check({.albedo = albedo, .g = g, .from = seed % 2 ? down : aslant, .depth = 1, .thickness = 3},
                  GUIDING_EIGEN, ++seed);
}

TEST(GuidedDirections, Dwivedi) {
    std::uint32_t seed = 81;
    for (const double albedo : {.01, .4, .9, .999999, 1.})
        check({.albedo = albedo, .g = 0, .from = aslant}, GUIDING_DWIVEDI, ++seed);
    for (const float depth : {0.f, .3f, 1.f})
        check({.albedo = .9, .g = 0, .from = up, .depth = depth, .thickness = 1, .far_light = 5}, GUIDING_DWIVEDI,
              ++seed);
}

} // namespace
} // namespace nacre::test
