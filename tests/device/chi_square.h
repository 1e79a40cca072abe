#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace nacre::test {

/// Regularised upper incomplete gamma function Q(a, x), a > 0, x >= 0, to 1e-12.
double gamma_q(double a, double x);

/// Probability that Pearson's statistic is as large as this or larger if `observed` was drawn with chances in
/// proportion to `shares`. Bins that expect fewer than 5 are pooled; 0 where something fell into bins (pooled) that
/// expect nothing.
double chi_square(const std::vector<std::uint64_t> &observed, const std::vector<double> &shares);

/// Expects p >= 1e-4 of `observed` against `shares`, and at least 10^6 samples. Seeds are fixed: a test that passes
/// does so for good on a device; a new one, or another device, has a false alarm in 10^4 (1 % for the ~ 100
/// distributions tested here).
void expect_distribution(const std::vector<std::uint64_t> &observed, const std::vector<double> &shares,
                         const std::string &what);

/// The same for points of the unit square (or numbers of the unit interval) that ought to be uniform.
void expect_uniform(const std::vector<double> &numbers, std::size_t bins, const std::string &what);
void expect_uniform(const std::vector<double> &x, const std::vector<double> &y, std::size_t bins,
                    const std::string &what);

} // namespace nacre::test
