#include "compare/flip.h"

namespace nacre::compare {
namespace {

// (k0 x^2 + k1 x) / (k3 x^2 + k4 x + k5): Narkowicz's fit of ACES, of .6 times the light (2021, section 3).
constexpr double k0 = 0.6 * 0.6 * 2.51, k1 = 0.6 * 0.03, k3 = 0.6 * 0.6 * 2.43, k4 = 0.6 * 0.59, k5 = 0.14;

float tone_mapped(double x) {
    x = std::min(x, 1e6); // it is 1 from 13 on; so the squares stay finite
    return float(std::clamp((k0 * x * x + k1 * x) / (k3 * x * x + k4 * x + k5), 0.0, 1.0));
}

/// The light that becomes `shown`.
double tone_inverse(double shown) {
    const double a = k0 - shown * k3, b = (k1 - shown * k4) / (2 * a), c = -shown * k5 / a;
    return -b + std::sqrt(b * b - c);
}

double light(float value) { return std::isfinite(value) && value > 0 ? value : 0; }

std::vector<Color> exposed(const Estimate &estimate, double stops) {
    std::vector<Color> colors(estimate.mean.size());
    const double scale = std::exp2(stops);
    for (std::size_t i = 0; i < colors.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) colors[i][c] = tone_mapped(scale * light(estimate.mean[i][c]));
    return colors;
}

} // namespace

Exposures exposures_of(const Estimate &reference) {
    std::vector<double> luminances;
    for (const auto &pixel : reference.mean) {
        const double y = 0.2126 * light(pixel[0]) + 0.7152 * light(pixel[1]) + 0.0722 * light(pixel[2]);
        // Not those of a black background, which may be more than half of them: the paper's median would be 0 then.
        if (y > 0) luminances.push_back(y);
    }
    if (luminances.empty()) return {};
    const auto middle = luminances.begin() + std::ptrdiff_t(luminances.size() / 2);
    std::nth_element(luminances.begin(), middle, luminances.end());
    const double median = *middle, brightest = *std::max_element(luminances.begin(), luminances.end());
    const double well = tone_inverse(0.85); // the paper's t_min and t_max
    Exposures exposures{std::log2(well / brightest), std::log2(well / median), 0};
    exposures.count = std::max(2, int(std::ceil(exposures.last - exposures.first)));
    return exposures;
}

Plane hdr_flip(const Estimate &test, const Estimate &reference) {
    const Exposures exposures = exposures_of(reference);
    Plane largest(test.width, test.height);
    for (int i = 0; i < exposures.count; ++i) {
        const Plane flip =
            ldr_flip(test.width, test.height, exposed(test, exposures.at(i)), exposed(reference, exposures.at(i)));
        for (std::size_t p = 0; p < largest.values.size(); ++p)
            largest.values[p] = std::max(largest.values[p], flip.values[p]);
    }
    return largest;
}

} // namespace nacre::compare
