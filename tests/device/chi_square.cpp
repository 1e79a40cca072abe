#include "device/chi_square.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>

namespace nacre::test {

// Press et al., "Numerical Recipes" (3rd ed.), section 6.2: the series below x = a + 1, the continued fraction above.
double gamma_q(double a, double x) {
    if (x <= 0) return 1;
    const double front = std::exp(a * std::log(x) - x - std::lgamma(a));
    if (x < a + 1) {
        double term = 1 / a, sum = term;
        for (double n = a + 1; term > sum * 1e-16; ++n) {
            term *= x / n;
            sum += term;
        }
        return 1 - front * sum;
    }
    double b = x + 1 - a, c = 1e300, d = 1 / b, fraction = d;
    for (int i = 1; i < 1000000; ++i) { // Lentz's method
        const double an = -i * (i - a);
        b += 2;
        d = 1 / (an * d + b);
        c = b + an / c;
        fraction *= d * c;
        if (std::abs(d * c - 1) < 1e-15) break;
    }
    return front * fraction;
}

double chi_square(const std::vector<std::uint64_t> &observed, const std::vector<double> &shares) {
    const double samples = double(std::accumulate(observed.begin(), observed.end(), std::uint64_t(0)));
    const double scale = samples / std::accumulate(shares.begin(), shares.end(), 0.0);
    double statistic = 0, few = 0, few_expected = 0;
    int bins = 0;
    const auto add = [&](double found, double expected) {
        statistic += (found - expected) * (found - expected) / expected;
        ++bins;
    };
    for (std::size_t i = 0; i < observed.size(); ++i) {
        const double expected = shares[i] * scale;
        if (expected < 5) {
            few += double(observed[i]);
            few_expected += expected;
        } else {
            add(double(observed[i]), expected);
        }
    }
    // A pool that expects next to nothing is no chi-square term, but an impossibility if it is not about empty.
    if (few_expected >= 5)
        add(few, few_expected);
    else if (few > few_expected + 25)
        return 0;
    return bins > 1 ? gamma_q(0.5 * (bins - 1), 0.5 * statistic) : 1;
}

// Stephens 1970; Press et al., section 14.3.3. The series for large arguments, Jacobi's transform of it for small ones.
double kolmogorov_q(double difference, double samples) {
    const double root = std::sqrt(samples), z = (root + .12 + .11 / root) * difference;
    if (z < 1e-3) return 1;
    double sum = 0;
    if (z < 1.18) {
        const double y = std::exp(-std::pow(std::numbers::pi / z, 2) / 8);
        for (int k = 1; k < 8; k += 2) sum += std::pow(y, k * k);
        return 1 - std::sqrt(2 * std::numbers::pi) / z * sum;
    }
    for (int k = 1; k < 8; ++k) sum += (k % 2 ? 2 : -2) * std::exp(-2 * k * k * z * z);
    return sum;
}

namespace {

/// Of the sums over bins.
double kolmogorov_smirnov(const std::vector<std::uint64_t> &observed, const std::vector<double> &shares) {
    const double samples = double(std::accumulate(observed.begin(), observed.end(), std::uint64_t(0)));
    const double all = std::accumulate(shares.begin(), shares.end(), 0.0);
    double worst = 0, found = 0, expected = 0;
    for (std::size_t i = 0; i < observed.size(); ++i) {
        found += double(observed[i]) / samples;
        expected += shares[i] / all;
        worst = std::max(worst, std::abs(found - expected));
    }
    return kolmogorov_q(worst, samples);
}

/// Bin of u in [0, 1]; what is outside goes to the nearest end, where it does not pass unseen.
std::size_t bin_of(double u, std::size_t bins) {
    return std::size_t(std::clamp(std::floor(u * double(bins)), 0.0, double(bins - 1)));
}

} // namespace

// Bins instead of sorting: the largest difference is found to 1.5e-5, of 1e6 numbers a hundredth of what is rare.
double kolmogorov_smirnov(const std::vector<double> &numbers) {
    constexpr std::size_t bins = 1 << 16;
    std::vector<std::uint64_t> observed(bins);
    for (const double u : numbers) ++observed[bin_of(u, bins)];
    return kolmogorov_smirnov(observed, std::vector<double>(bins, 1));
}

void expect_distribution(const std::vector<std::uint64_t> &observed, const std::vector<double> &shares,
                         const std::string &what) {
    ASSERT_EQ(observed.size(), shares.size()) << what;
    EXPECT_GE(std::accumulate(observed.begin(), observed.end(), std::uint64_t(0)), 1000000u) << what;
    EXPECT_GE(chi_square(observed, shares), 1e-4) << what;
    EXPECT_GE(kolmogorov_smirnov(observed, shares), 1e-4) << what << ", Kolmogorov-Smirnov";
}

void expect_uniform(const std::vector<double> &numbers, std::size_t bins, const std::string &what) {
    std::vector<std::uint64_t> observed(bins);
    for (const double u : numbers) ++observed[bin_of(u, bins)];
    expect_distribution(observed, std::vector<double>(bins, 1), what);
    EXPECT_GE(kolmogorov_smirnov(numbers), 1e-4) << what << ", Kolmogorov-Smirnov";
}

std::vector<std::uint64_t> pairs_in_bins(const std::vector<double> &x, const std::vector<double> &y, std::size_t bins) {
    std::vector<std::uint64_t> observed(bins * bins);
    for (std::size_t i = 0; i < x.size(); ++i) ++observed[bin_of(y[i], bins) * bins + bin_of(x[i], bins)];
    return observed;
}

void expect_uniform(const std::vector<double> &x, const std::vector<double> &y, std::size_t bins,
                    const std::string &what) {
    expect_distribution(pairs_in_bins(x, y, bins), std::vector<double>(bins * bins, 1), what);
    EXPECT_GE(kolmogorov_smirnov(x), 1e-4) << what << ", Kolmogorov-Smirnov of the first";
    EXPECT_GE(kolmogorov_smirnov(y), 1e-4) << what << ", Kolmogorov-Smirnov of the second";
}

} // namespace nacre::test
