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

/// Probability that the largest difference of an empirical distribution function of `samples` numbers from the true one
/// is `difference` or more: Kolmogorov's limit with Stephens' correction.
double kolmogorov_q(double difference, double samples);

/// Kolmogorov and Smirnov's test of numbers that ought to be uniform on [0, 1]: the probability of their largest
/// difference or a larger one. It sees what is shifted a little everywhere, which chi-square does not.
double kolmogorov_smirnov(const std::vector<double> &numbers);

/// Expects p >= 1e-4 of `observed` against `shares`, by chi-square and, of the sums from the first bin on, by
/// Kolmogorov and Smirnov (whose p is too large for bins, never too small), and at least 10^6 samples. Seeds are fixed:
/// a test that passes does so for good on a device; a new one, or another device, has a false alarm in 10^4 (2 % for
/// the ~ 100 distributions tested here).
void expect_distribution(const std::vector<std::uint64_t> &observed, const std::vector<double> &shares,
                         const std::string &what);

/// The same for points of the unit square (or numbers of the unit interval) that ought to be uniform; Kolmogorov and
/// Smirnov's test is of the numbers themselves, of the square's of either coordinate.
void expect_uniform(const std::vector<double> &numbers, std::size_t bins, const std::string &what);
std::vector<std::uint64_t> pairs_in_bins(const std::vector<double> &x, const std::vector<double> &y, std::size_t bins);
void expect_uniform(const std::vector<double> &x, const std::vector<double> &y, std::size_t bins,
                    const std::string &what);

} // namespace nacre::test
