#include "compare/metrics.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace nacre::compare {
namespace {

template <typename F> void for_values(const Estimate &a, const Estimate &b, const F &each) {
    for (std::size_t i = 0; i < a.mean.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            if (const double x = a.mean[i][c], y = b.mean[i][c]; std::isfinite(x) && std::isfinite(y)) each(x, y);
}

} // namespace

Metrics metrics(const Estimate &a, const Estimate &b) {
    double count = 0, sum = 0, peak = 0, squares = 0, relative = 0;
    for_values(a, b, [&](double x, double y) {
        ++count;
        sum += y;
        peak = std::max(peak, y);
        squares += (x - y) * (x - y);
    });
    const double mean = count > 0 ? sum / count : 0, floor = 0.01 * mean * mean;
    for_values(a, b, [&](double x, double y) {
        if (x != y) relative += (x - y) * (x - y) / (y * y + floor); // infinite against a reference that is all black
    });
    Metrics result;
    if (count == 0) return result;
    result.mse = squares / count;
    result.relmse = relative / count;
    result.psnr = squares > 0 ? 10 * std::log10(peak * peak / result.mse) : std::numeric_limits<double>::infinity();
    return result;
}

} // namespace nacre::compare
