// The functions that the kernels lean on, those of lanes/math.h, of lanes/scalar.h and built-ins: their errors over all
// floats, their edges, and the same bits for any LANES.
#include "device/context.h"
#include "device/lane_probe.h"
#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace nacre::test {
namespace {

using Bits = std::vector<std::uint32_t>;

constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
constexpr std::uint32_t chunk = 1 << 20, minus = 0x80000000u, infinite = 0x7f800000u;

struct Case {
    Function function;
    const char *name;
    double (*exact)(double);
    double ulp;
    std::uint32_t first, last; // bits of the domain's ends
};

double log_of(double x) { return std::log(x); }
double exp_of(double x) { return std::exp(x) < 0x1p-126 ? 0 : std::exp(x); } // no denormal results
double log1p_of(double x) { return std::log1p(x); }
double expm1_of(double x) { return std::expm1(x); }
double sine_of(double x) { return std::sin(2 * std::numbers::pi * x); }
double root_of(double x) { return std::sqrt(x); }
double inverse_of(double x) { return 1 / x; }
double square_less_one_of(double x) { return std::fma(x, x, -1); }
double floor_of(double x) { return std::floor(x); }
double atan2_x_1_of(double x) { return std::atan2(x, 1); }
double atan2_1_x_of(double x) { return std::atan2(1, x); }
double length3_of(double x) { return std::sqrt(3.0) * std::abs(x); }
double normalised3_of(double x) { return std::copysign(1 / std::sqrt(3.0), x); }

constexpr Case cases[] = {
    {Function::log, "log", log_of, 1.2, 0x00800000u, infinite},
    {Function::exp, "exp, x >= 0", exp_of, 1.1, 0, infinite},
    {Function::exp, "exp, x <= 0", exp_of, 1.1, minus, minus | infinite},
    {Function::log1p, "log1p, x >= 0", log1p_of, 2, 0, infinite},
    {Function::log1p, "log1p, x <= 0", log1p_of, 2, minus, 0xbf7fffffu},
    {Function::expm1, "expm1, x >= 0", expm1_of, 1.7, 0, infinite},
    {Function::expm1, "expm1, x <= 0", expm1_of, 1.7, minus, minus | infinite},
    {Function::sine, "sin 2 pi x, x <= 1/8", sine_of, 2, 0x00800000u, 0x3e000000u},
    // Built-ins, where the kernels use them: [2^-64, 2^64]. Bounds are OpenCL's (1.2, table 7.1). Sizes, in units of
    // the scene's: [2^-40, 2^40].
    {Function::root, "sqrt", root_of, 3, 0x1f800000u, 0x5f800000u},
    {Function::inverse, "1 / x", inverse_of, 2.5, 0x1f800000u, 0x5f800000u},
    {Function::square_less_one, "fma(x, x, -1)", square_less_one_of, 0.5001, 0x1f800000u, 0x5f000000u},
    // Those of lanes/scalar.h.
    {Function::floor, "floor, x >= 0", floor_of, 0, 0x00800000u, 0x7f7fffffu},
    {Function::floor, "floor, x <= 0", floor_of, 0, minus | 0x00800000u, minus | 0x7f7fffffu},
    {Function::atan2_x_1, "atan2(x, 1), x >= 0", atan2_x_1_of, 3, 0x1f800000u, 0x5f800000u},
    {Function::atan2_x_1, "atan2(x, 1), x <= 0", atan2_x_1_of, 3, minus | 0x1f800000u, minus | 0x5f800000u},
    {Function::atan2_1_x, "atan2(1, x), x >= 0", atan2_1_x_of, 3, 0x1f800000u, 0x5f800000u},
    {Function::atan2_1_x, "atan2(1, x), x <= 0", atan2_1_x_of, 3, minus | 0x1f800000u, minus | 0x5f800000u},
    {Function::length3, "length", length3_of, 2, 0x2b800000u, 0x53800000u},
    {Function::normalised3, "normalize", normalised3_of, 3, 0x2b800000u, 0x53800000u},
};

/// OpenCL lets devices round roots by 3 and quotients by 2.5 ulp; processors round as IEEE 754 does, which is held.
double bound_of(const Case &c, bool processor) {
    const bool quotient_or_root = c.function == Function::root || c.function == Function::inverse;
    const bool has_both = c.function >= Function::atan2_x_1;
    if (processor) return quotient_or_root ? 0.5001 : c.ulp;
    return has_both ? c.ulp + 5.5 : c.ulp;
}

/// Distance in units of the last place of the exact value. Devices may take denormal numbers for 0.
double ulps(float found, double exact) {
    if (std::isinf(float(exact))) return found == float(exact) ? 0 : inf;
    if (std::abs(exact) < 0x1p-126) return std::abs(found) <= 0x1p-126 ? 0 : inf;
    if (!std::isfinite(found)) return inf;
    return std::abs(found - exact) / std::ldexp(1.0, std::ilogb(exact) - 23);
}

/// Bits first, first + stride, ..., last, and the first and last 2^12 one by one.
void sweep(const Case &c, std::uint32_t stride) {
    double worst = 0;
    float worst_at = 0;
    Bits in;
    const auto flush = [&] {
        in.resize((in.size() + 4095) / 4096 * 4096, c.last);
        const Bits scalar = run_function(1, c.function, in);
        for (std::size_t i = 0; i < in.size(); ++i) {
            const float x = std::bit_cast<float>(in[i]);
            const double error = ulps(std::bit_cast<float>(scalar[i]), c.exact(x));
            if (error > worst) worst_at = x;
            worst = std::max(worst, error);
        }
        for (const int lanes : lane_counts)
            EXPECT_EQ(run_function(lanes, c.function, in), scalar) << c.name << ", " << lanes << " lanes";
        in.clear();
    };
    for (std::uint32_t edge = 0; edge < 4096; ++edge) in.insert(in.end(), {c.first + edge, c.last - edge});
    for (std::uint64_t bits = c.first; bits <= c.last; bits += stride) {
        in.push_back(std::uint32_t(bits));
        if (in.size() == chunk) flush();
    }
    flush();
    const bool processor = device::open_device().info.type & CL_DEVICE_TYPE_CPU;
    const double bound = bound_of(c, processor);
    EXPECT_LE(worst, bound) << c.name << " at " << worst_at;
    fmt::print("  {:<24}{:6.3f} of {} ulp, at {}\n", c.name, worst, bound, worst_at);
}

TEST(LaneMath, ErrorsOverAllFloats) {
    for (const Case &c : cases) sweep(c, 257);
}

TEST(LongLaneMath, ErrorsOverAllFloats) {
    for (const Case &c : cases) sweep(c, 1);
}

TEST(LaneMath, Edges) {
    struct Edge {
        Function function;
        float x, result;
    };
    const Edge edges[] = {{Function::log, 0, -inf},
                          {Function::log, -0.0f, -inf},
                          {Function::log, 1, 0},
                          {Function::log, inf, inf},
                          {Function::log, -1e-38f, nan},
                          {Function::log, -1, nan},
                          {Function::log, -inf, nan},
                          {Function::log, nan, nan},
                          {Function::exp, 0, 1},
                          {Function::exp, -0.0f, 1},
                          {Function::exp, inf, inf},
                          {Function::exp, -inf, 0},
                          {Function::exp, nan, nan},
                          {Function::exp, 88.72284f, inf},
                          {Function::exp, -87.33655f, 0},
                          {Function::exp, 1e30f, inf},
                          {Function::exp, -1e30f, 0},
                          {Function::exp, -0x1.5d589ep+6f, 0x1.00004cp-126f}, // the last normal number
                          {Function::log1p, 0, 0},
                          {Function::log1p, inf, inf},
                          {Function::log1p, nan, nan},
                          {Function::log1p, 1e-30f, 1e-30f},
                          {Function::expm1, 0, 0},
                          {Function::expm1, inf, inf},
                          {Function::expm1, -inf, -1},
                          {Function::expm1, nan, nan},
                          {Function::expm1, 88.72284f, inf},
                          {Function::expm1, -1e30f, -1},
                          {Function::expm1, 1e-30f, 1e-30f}};
    for (const Edge &edge : edges) {
        const Bits in(4096, std::bit_cast<std::uint32_t>(edge.x));
        for (const int lanes : lane_counts) {
            const float found = std::bit_cast<float>(run_function(lanes, edge.function, in)[4095]);
            const bool same = std::isnan(edge.result) ? std::isnan(found) : found == edge.result;
            EXPECT_TRUE(same) << int(edge.function) << " of " << edge.x << " is " << found << " with " << lanes;
        }
    }
    const Bits denormal(4096, 0x00400000u);
    const float found = std::bit_cast<float>(run_function(1, Function::log, denormal)[0]);
    EXPECT_TRUE(found == -inf || (found >= std::log(0x1p-127f) && found <= std::log(0x1p-126f))) << found;
}

TEST(LaneMath, SineAndCosineOfTurns) {
    Bits in;
    for (std::uint32_t i = 0; i < 1u << 20; ++i) in.push_back(std::bit_cast<std::uint32_t>(float(i + 1) * 0x1p-20f));
    for (const Function function : {Function::sine, Function::cosine}) {
        const Bits scalar = run_function(1, function, in);
        double worst = 0;
        for (std::size_t i = 0; i < in.size(); ++i) {
            const double angle = 2 * std::numbers::pi * std::bit_cast<float>(in[i]);
            const double exact = function == Function::sine ? std::sin(angle) : std::cos(angle);
            worst = std::max(worst, std::abs(std::bit_cast<float>(scalar[i]) - exact));
        }
        EXPECT_LE(worst, 2e-7);
        for (const int lanes : lane_counts) EXPECT_EQ(run_function(lanes, function, in), scalar) << lanes << " lanes";
    }
}

} // namespace
} // namespace nacre::test
