// How far the colour of a half-space is off what was asked for, by each way to invert it: the table of the README.
#include "albedo/inversion.h"
#include "albedo/half_space.h"
#include "albedo/memo.h"
#include "base/parallel.h"
#include "io/srgb.h"
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <mutex>
#include <vector>

namespace {

using namespace nacre;
using namespace nacre::shared;
using Inverse = std::function<double(double color, const albedo::Medium &)>; // albedo

/// A quadratic in similarity whose two parameters are polynomials of g and bleed, fitted to colours for bleed <= 1.
double closed_form(double x, const albedo::Medium &medium) {
    const double g = medium.anisotropy, b = medium.bleed;
    const double B = 0.094184 - 0.023202 * b + g * (0.178451 - 0.023191 * b) + g * g * (-0.171307 + 0.027759 * b) +
                     g * g * g * (0.069994 - 0.05113 * b);
    const double C = 1.226252 - 0.060765 * b + g * (-0.214466 + 0.006146 * b) + g * g * (0.176153 - 0.041805 * b) +
                     g * g * g * (-0.052011 + 0.079804 * b);
    const double h = 1 + B + C * x;
    return albedo::albedo_of(2 * (1 - x) / (h + std::sqrt(h * h - 4 * B * (1 - x))), g);
}

struct Row {
    const char *name;
    Inverse inverse;
    double least_g, largest_g;
    std::vector<double> bleeds;
    std::vector<FlightLaw> laws = {FLIGHT_RENEWAL};
};

Inverse by(Inversion inversion) {
    return [inversion](double x, const albedo::Medium &medium) { return albedo::albedo(inversion, x, medium); };
}

Inverse by(const albedo::MemoFit &fit) {
    return [&fit](double x, const albedo::Medium &medium) { return albedo::memo_albedo(fit, x, medium.anisotropy); };
}

struct Error {
    double largest = 0, sum = 0, codes = 0; // codes: largest, of 8-bit sRGB
    int count = 0;
};

Error error_of(const Row &row) {
    constexpr std::size_t anisotropies = 11;
    constexpr int colors = 200;
    Error error;
    std::mutex guard;
    parallel_for(anisotropies * row.bleeds.size() * row.laws.size(), [&](std::size_t k) {
        const double g = std::lerp(row.least_g, row.largest_g, double(k % anisotropies) / (anisotropies - 1));
        const double bleed = row.bleeds[k / anisotropies % row.bleeds.size()];
        const FlightLaw law = row.laws[k / anisotropies / row.bleeds.size()];
        const albedo::HalfSpace medium(g, bleed, law);
        for (int i = 0; i < colors; ++i) {
            const double x = std::lerp(.002, .999, i / (colors - 1.0));
            const double a = std::clamp(row.inverse(x, {.anisotropy = g, .bleed = bleed, .flight = law}), 0.0, 1.0);
            const double found = medium.color(std::sqrt((1 - a) / (1 - g * a)), ENTRY_LAMBERT),
                         off = std::abs(found - x);
            const double codes = 255 * std::abs(io::linear_to_srgb(found) - io::linear_to_srgb(x));
            const std::lock_guard lock(guard);
            error.largest = std::max(error.largest, off);
            error.codes = std::max(error.codes, codes);
            error.sum += off;
            ++error.count;
        }
    });
    return error;
}

} // namespace

int main() {
    const Row rows[] = {
        {"`table`, exponential flights", by(INVERSION_TABLE), -.9, .95, {0}},
        {"`table`, bleed to 4, both flights",
         by(INVERSION_TABLE),
         -.9,
         .95,
         {.05, .25, .6, 1, 2, 4},
         {FLIGHT_RENEWAL, FLIGHT_RECIPROCAL}},
        {"closed form of 16 coefficients", closed_form, -.9, .95, {0}},
        {"closed form, bleed to 1", closed_form, -.9, .95, {.25, .5, .75, 1}},
        {"`memo`, our coefficients, g >= 0", by(albedo::uncapped_fit), 0, .95, {0}},
        {"memo, published coefficients, g >= 0", by(albedo::published_fit), 0, .95, {0}},
        {"`van_de_hulst`", by(INVERSION_VAN_DE_HULST), -.9, .95, {0}},
        {"`chiang`, g = 0", by(INVERSION_CHIANG), 0, 0, {0}},
    };
    fmt::print(
        "| inversion | largest error of a colour | mean | largest in codes of 8-bit sRGB |\n|---|---|---|---|\n");
    for (const Row &row : rows) {
        const Error error = error_of(row);
        fmt::print("| {} | {:.2g} | {:.1e} | {:.2f} |\n", row.name, error.largest, error.sum / error.count,
                   error.codes);
    }
}
