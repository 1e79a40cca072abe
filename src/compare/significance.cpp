#include "compare/significance.h"
#include "compare/tail.h"
#include <algorithm>
#include <cmath>

namespace nacre::compare {
namespace {

constexpr int families = 3;

double rounding_of(const Measured &a, const Measured &b) { return std::max(a.rounding, b.rounding); }

double less_rounding(double difference, double rounding) {
    return std::copysign(std::max(0.0, std::abs(difference) - rounding), difference);
}

/// Of the difference, from the spread of the samples: what each picture says of itself (Welch), or what both say
/// together (Student), whichever is more.
double variance_by_spread(const Measured &a, const Measured &b) {
    const double freedom = a.samples + b.samples - 2;
    if (!(freedom > 0)) return 0;
    const double squares = (a.samples - 1) * a.samples * a.variance + (b.samples - 1) * b.samples * b.variance;
    return std::max(a.variance + b.variance, squares / freedom * (1 / a.samples + 1 / b.samples));
}

/// Keeps the worst of a family's differences.
void take(Family &family, const Difference &difference, int x, int y, int channel) {
    const double z = difference.z();
    ++family.tested;
    if (family.tested > 1 && !(std::abs(z) > std::abs(family.z))) return;
    family.z = z;
    family.x = x;
    family.y = y;
    family.channel = channel;
}

void judge(Family &family, double alpha) {
    if (family.tested == 0) return;
    const double count = double(family.tested);
    family.limit = sign_limit(sidak_level(sidak_level(alpha, families), count));
    family.p = sidak(sign_tail(family.z), count);
}

/// Calls `each` with the differences of all pixels' channels, with their places.
template <typename F> void for_pixels(const Estimate &a, const Estimate &b, const F &each) {
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            const std::size_t pixel = std::size_t(y) * std::size_t(a.width) + std::size_t(x);
            if (!tested(a, b, pixel)) continue;
            for (int c = 0; c < 3; ++c) each(pixel_difference(a.at(pixel, c), b.at(pixel, c)), x, y, c);
        }
}

/// The same of all tiles'.
template <typename F> void for_tiles(const Estimate &a, const Estimate &b, const F &each) {
    for (int y = 0; y < a.height; y += tile_size)
        for (int x = 0; x < a.width; x += tile_size)
            for (int c = 0; c < 3; ++c)
                each(
                    mean_difference(a, b, c, x, y, std::min(x + tile_size, a.width), std::min(y + tile_size, a.height)),
                    x, y, c);
}

} // namespace

bool finite(const Estimate &a, const Estimate &b, std::size_t pixel) {
    for (const Estimate *estimate : {&a, &b}) {
        if (estimate->has_noise() && !std::isfinite(estimate->samples[pixel])) return false;
        for (std::size_t c = 0; c < 3; ++c)
            if (!std::isfinite(estimate->mean[pixel][c]) ||
                (estimate->has_noise() &&
                 !(std::isfinite(estimate->variance[pixel][c]) && estimate->variance[pixel][c] >= 0)))
                return false;
    }
    return true;
}

bool tested(const Estimate &a, const Estimate &b, std::size_t pixel) {
    return a.samples[pixel] >= 1 && b.samples[pixel] >= 1 && finite(a, b, pixel);
}

Difference pixel_difference(const Measured &a, const Measured &b) {
    const double value = less_rounding(a.mean - b.mean, rounding_of(a, b));
    const double fewer = std::min(a.samples, b.samples);
    return {value, std::sqrt(variance_by_spread(a, b) + value * value / (2 * fewer - 1))};
}

Difference mean_difference(const Estimate &a, const Estimate &b, int channel, int x0, int y0, int x1, int y1) {
    double sum = 0, variance = 0, squares = 0, rounding = 0, count = 0;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
            const std::size_t pixel = std::size_t(y) * std::size_t(a.width) + std::size_t(x);
            if (!tested(a, b, pixel)) continue;
            const Measured first = a.at(pixel, channel), second = b.at(pixel, channel);
            const double difference = first.mean - second.mean;
            sum += difference;
            squares += difference * difference;
            variance += variance_by_spread(first, second);
            rounding += rounding_of(first, second);
            ++count;
        }
    if (count == 0) return {};
    return {less_rounding(sum, rounding) / count, std::sqrt(std::max(variance, squares)) / count};
}

Verdict test(const Estimate &a, const Estimate &b, double alpha) {
    Verdict verdict;
    verdict.alpha = alpha;
    double count = 0;
    for (std::size_t pixel = 0; pixel < a.mean.size(); ++pixel) {
        if (!finite(a, b, pixel)) {
            if (verdict.not_finite++ == 0) {
                verdict.not_finite_x = int(pixel % std::size_t(a.width));
                verdict.not_finite_y = int(pixel / std::size_t(a.width));
            }
        } else if (!tested(a, b, pixel))
            ++verdict.untested;
        else {
            ++count;
            for (std::size_t c = 0; c < 3; ++c) {
                verdict.channels[c].mean_a += a.mean[pixel][c];
                verdict.channels[c].mean_b += b.mean[pixel][c];
            }
        }
    }
    if (count == 0) return verdict;

    const auto test_family = [&](Family &family, const auto &for_all) {
        for_all(a, b, [&](const Difference &d, int x, int y, int c) { take(family, d, x, y, c); });
        judge(family, alpha);
        for_all(a, b, [&](const Difference &d, int, int, int) { family.beyond += std::abs(d.z()) > family.limit; });
    };
    test_family(verdict.pixels, [](const auto &...arguments) { for_pixels(arguments...); });
    test_family(verdict.tiles, [](const auto &...arguments) { for_tiles(arguments...); });
    for (int c = 0; c < 3; ++c) {
        const Difference difference = mean_difference(a, b, c, 0, 0, a.width, a.height);
        Channel &channel = verdict.channels[c];
        channel.mean_a /= count;
        channel.mean_b /= count;
        channel.error = difference.error;
        channel.z = difference.z();
        take(verdict.picture, difference, 0, 0, c);
    }
    judge(verdict.picture, alpha);
    for (const Channel &channel : verdict.channels)
        verdict.picture.beyond += std::abs(channel.z) > verdict.picture.limit;
    verdict.p = sidak(std::min({verdict.pixels.p, verdict.tiles.p, verdict.picture.p}), families);
    return verdict;
}

} // namespace nacre::compare
