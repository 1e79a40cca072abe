#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

// What runs of a renderer are summed up to. Nothing here leaves out a value.
namespace nacre::bench {

/// y = intercept + slope x.
struct Line {
    double slope = 0, intercept = 0;
    double at(double x) const { return intercept + slope * x; }
};

/// By least squares. At least two points whose x differ.
Line fit_line(std::span<const double> x, std::span<const double> y);

/// Through the logarithms of both: the slope is the power by which y goes with x. All numbers > 0.
Line fit_power(std::span<const double> x, std::span<const double> y);

double mean(std::span<const double> values);

/// Of the values' mean: their spread (n - 1) over the root of their number. At least two values.
double standard_error(std::span<const double> values);

/// The smallest value that at least the share `p` (0 < p <= 1) of the values does not exceed. Not empty.
double percentile(std::vector<double> values, double p);

/// A figure and where 95 % of its bootstrap replicates lie.
struct Interval {
    double value = 0, low = 0, high = 0;
};

/// `statistic` takes indices below `count`: once all of them, then 2000 times as many drawn with replacement, the same
/// draws in every call (Efron 1979; percentile intervals).
Interval bootstrap(std::size_t count, const std::function<double(std::span<const std::size_t>)> &statistic);

} // namespace nacre::bench
