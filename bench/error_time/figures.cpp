#include "error_time/figures.h"
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace nacre::bench {

Line fit_line(std::span<const double> x, std::span<const double> y) {
    const double middle_x = mean(x), middle_y = mean(y);
    double products = 0, squares = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        products += (x[i] - middle_x) * (y[i] - middle_y);
        squares += (x[i] - middle_x) * (x[i] - middle_x);
    }
    const double slope = products / squares;
    return {slope, middle_y - slope * middle_x};
}

Line fit_power(std::span<const double> x, std::span<const double> y) {
    std::vector<double> log_x, log_y;
    for (std::size_t i = 0; i < x.size(); ++i) {
        log_x.push_back(std::log(x[i]));
        log_y.push_back(std::log(y[i]));
    }
    return fit_line(log_x, log_y);
}

double mean(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

double standard_error(std::span<const double> values) {
    const double middle = mean(values), count = double(values.size());
    double squares = 0;
    for (const double value : values) squares += (value - middle) * (value - middle);
    return std::sqrt(squares / (count - 1) / count);
}

double percentile(std::vector<double> values, double p) {
    // p n may be a hair above a whole number that it should be.
    const double rank = std::ceil(p * double(values.size()) * (1 - 1e-12));
    const auto at = values.begin() + std::ptrdiff_t(std::max(1.0, rank)) - 1;
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

Interval bootstrap(std::size_t count, const std::function<double(std::span<const std::size_t>)> &statistic) {
    constexpr int replicates = 2000;
    std::vector<std::size_t> indices(count);
    std::iota(indices.begin(), indices.end(), std::size_t{0});
    Interval interval;
    interval.value = statistic(indices);
    std::mt19937_64 random; // its default seed
    std::vector<double> found;
    for (int i = 0; i < replicates; ++i) {
        for (std::size_t &index : indices) index = random() % count;
        found.push_back(statistic(indices));
    }
    interval.low = percentile(found, .025);
    interval.high = percentile(found, .975);
    return interval;
}

} // namespace nacre::bench
