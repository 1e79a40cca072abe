#include "compare/flip.h"
#include "base/parallel.h"
#include <numeric>
#include <span>

namespace nacre::compare {
namespace {

using std::numbers::pi;

/// f(-radius) ... f(radius).
template <typename F> Taps taps_of(int radius, const F &f) {
    Taps taps;
    for (int i = -radius; i <= radius; ++i) taps.push_back(float(f(double(i))));
    return taps;
}

/// Weights above 0 add up to 1 then, those below to -1.
Taps normalised(Taps taps) {
    float above = 0, below = 0;
    for (const float t : taps) (t > 0 ? above : below) += std::abs(t);
    for (float &t : taps) t /= t > 0 ? above : below;
    return taps;
}

/// A term a sqrt(pi/b) exp(-pi^2 r^2 / b) of a contrast sensitivity function, r in degrees (2020, equation 3, table 1).
struct Term {
    double a, b;
};
constexpr Term achromatic{1, 0.0047}, red_green{1, 0.0053}, blue_yellow[] = {{34.1, 0.04}, {13.5, 0.025}};

/// What an eye at this distance sees of one opponent channel: its sensitivity is a sum of Gaussians, each of them one
/// across times one down.
Plane seen(const Plane &plane, std::span<const Term> terms) {
    // Three standard deviations of the widest of all.
    const int radius = int(std::ceil(3 * std::sqrt(blue_yellow[0].b / (2 * pi * pi)) * pixels_per_degree));
    Plane sum(plane.width, plane.height);
    double total = 0;
    for (const Term &term : terms) {
        const Taps taps = taps_of(radius, [&](double i) {
            const double degrees = i / pixels_per_degree;
            return std::exp(-pi * pi * degrees * degrees / term.b);
        });
        const double weight = term.a * std::sqrt(pi / term.b), side = std::accumulate(taps.begin(), taps.end(), 0.0);
        const Plane part = filtered(plane, taps, taps);
        for (std::size_t i = 0; i < sum.values.size(); ++i) sum.values[i] += float(weight) * part.values[i];
        total += weight * side * side;
    }
    for (float &value : sum.values) value /= float(total);
    return sum;
}

/// A picture as both halves of the metric need it.
struct Seen {
    std::vector<Color> lab;
    Plane edges, points; // how strong they are
};

Plane length_of(const Plane &a, const Plane &b) {
    Plane result(a.width, a.height);
    for (std::size_t i = 0; i < result.values.size(); ++i) result.values[i] = std::hypot(a.values[i], b.values[i]);
    return result;
}

/// Edges and points by the first and second derivatives of a Gaussian that is .082 degrees wide (2020, section 4.3).
std::pair<Plane, Plane> features_of(Plane luminance) {
    const double deviation = 0.5 * 0.082 * pixels_per_degree;
    const int radius = int(std::ceil(3 * deviation));
    const auto gauss = [&](double x) { return std::exp(-x * x / (2 * deviation * deviation)); };
    const Taps smooth = normalised(taps_of(radius, gauss));
    const Taps edge = normalised(taps_of(radius, [&](double x) { return -x * gauss(x); }));
    const Taps point =
        normalised(taps_of(radius, [&](double x) { return (x * x / (deviation * deviation) - 1) * gauss(x); }));
    for (float &y : luminance.values) y = (y + 16) / 116;
    return {length_of(filtered(luminance, edge, smooth), filtered(luminance, smooth, edge)),
            length_of(filtered(luminance, point, smooth), filtered(luminance, smooth, point))};
}

Seen see(int width, int height, const std::vector<Color> &rgb) {
    std::array<Plane, 3> planes{Plane(width, height), Plane(width, height), Plane(width, height)};
    for (std::size_t i = 0; i < rgb.size(); ++i) {
        const Color color = opponent(rgb[i]);
        for (std::size_t c = 0; c < 3; ++c) planes[c].values[i] = color[c];
    }
    const Plane y = seen(planes[0], {&achromatic, 1}), x = seen(planes[1], {&red_green, 1}),
                z = seen(planes[2], blue_yellow);
    std::vector<Color> lab(rgb.size());
    for (std::size_t i = 0; i < rgb.size(); ++i)
        lab[i] = hunt_lab(rgb_of_opponent({y.values[i], x.values[i], z.values[i]}));
    auto [edges, points] = features_of(std::move(planes[0]));
    return {std::move(lab), std::move(edges), std::move(points)};
}

} // namespace

Plane ldr_flip(int width, int height, const std::vector<Color> &test, const std::vector<Color> &reference) {
    const Seen a = see(width, height, test), b = see(width, height, reference);
    // The largest difference of two colours is that of green and blue; up to .4 of it takes up .95 of the scale
    // (2020, section 4.2).
    const float exponent = 0.7f, largest = std::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), exponent);
    const float bend = 0.4f * largest, at_bend = 0.95f;
    Plane result(width, height);
    for (std::size_t i = 0; i < result.values.size(); ++i) {
        const float distance = std::pow(hyab(a.lab[i], b.lab[i]), exponent);
        const float color = distance < bend ? at_bend / bend * distance
                                            : at_bend + (distance - bend) / (largest - bend) * (1 - at_bend);
        const float feature = std::max(std::abs(a.edges.values[i] - b.edges.values[i]),
                                       std::abs(a.points.values[i] - b.points.values[i]));
        result.values[i] = std::pow(color, 1 - std::sqrt(feature / std::sqrt(2.0f)));
    }
    return result;
}

} // namespace nacre::compare
