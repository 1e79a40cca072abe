#include "error_time/analysis.h"
#include "compare/flip.h"
#include "compare/metrics.h"
#include "compare/significance.h"
#include <algorithm>
#include <cmath>
#include <map>

namespace nacre::bench {
namespace {

using compare::Estimate;

/// What squares of differences are divided by: as in compare/metrics.h.
std::vector<std::array<double, 3>> squares_of(const Estimate &reference) {
    const double level = level_of(reference);
    std::vector<std::array<double, 3>> squares(reference.mean.size());
    for (std::size_t i = 0; i < squares.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            squares[i][c] = double(reference.mean[i][c]) * double(reference.mean[i][c]) + .01 * level * level;
    return squares;
}

class Analysis {
  public:
    Analysis(const Series &series, const Reference &reference)
        : series(series), reference(reference), squares(squares_of(reference.picture)) {
        for (std::size_t i = 0; i < squares.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                noise += reference.variance[i][c] / squares[i][c] / (3 * double(squares.size()));
        for (const Shot &shot : series.shots) by_budget[shot.spp].push_back(&shot);
    }

    Result result() {
        Result result;
        result.name = series.name;
        result.startup = series.startup;
        for (const auto &[spp, shots] : by_budget) add_budget(result, spp, shots);
        check(result);
        fit(result);
        return result;
    }

  private:
    const Series &series;
    const Reference &reference;
    std::vector<std::array<double, 3>> squares;
    double noise = 0; // that the reference adds to relmse
    std::map<std::uint32_t, std::vector<const Shot *>> by_budget;

    /// Of a pixel, its worst channel.
    double pixel_error(const Estimate &picture, std::size_t pixel) const {
        double worst = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double off = double(picture.mean[pixel][c]) - double(reference.picture.mean[pixel][c]);
            worst = std::max(worst, std::abs(off) / std::sqrt(squares[pixel][c]));
        }
        return worst;
    }

    double relative_square(const Estimate &picture, const Estimate &center) const {
        double sum = 0;
        for (std::size_t i = 0; i < squares.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c) {
                const double off = double(picture.mean[i][c]) - double(center.mean[i][c]);
                sum += off * off / squares[i][c];
            }
        return sum / (3 * double(squares.size()));
    }

    static Estimate mean_picture(const std::vector<const Shot *> &shots) {
        std::vector<const Estimate *> pictures;
        for (const Shot *shot : shots) pictures.push_back(&shot->picture);
        return mean_of(pictures);
    }

    void add_budget(Result &result, std::uint32_t spp, const std::vector<const Shot *> &shots) {
        const double count = double(shots.size());
        const Estimate middle = mean_picture(shots);
        Budget budget;
        budget.spp = spp;
        std::vector<double> errors, levels, variances, seconds;
        for (const Shot *shot : shots) {
            const compare::Metrics metrics = compare::metrics(shot->picture, reference.picture);
            Distance d{spp, shot->seed, shot->seconds, shot->cpu, metrics.mse, metrics.relmse, 0, 0, 0, 0};
            std::vector<double> own;
            for (std::size_t i = 0; i < squares.size(); ++i) own.push_back(pixel_error(shot->picture, i));
            errors.insert(errors.end(), own.begin(), own.end());
            d.worst = percentile(std::move(own), .999);
            const compare::Plane flip = compare::hdr_flip(shot->picture, reference.picture);
            for (const float value : flip.values) d.flip += double(value) / double(flip.values.size());
            d.variance = relative_square(shot->picture, middle) * count / (count - 1);
            d.level = level_of(shot->picture);
            budget.seconds += d.seconds / count;
            budget.cpu += d.cpu / count;
            budget.mse += d.mse / count;
            budget.relmse += (d.relmse - noise) / count;
            budget.flip += d.flip / count;
            levels.push_back(d.level);
            variances.push_back(d.variance);
            seconds.push_back(d.seconds);
            result.distances.push_back(d);
        }
        budget.worst = percentile(std::move(errors), .999);
        const double truth = mean(reference.level), off = mean(levels) - truth;
        budget.bias = off / truth;
        budget.bias_z = off / std::hypot(standard_error(levels), standard_error(reference.level));
        budget.efficiency = bootstrap(shots.size(), [&](std::span<const std::size_t> indices) {
            double variance = 0, time = 0;
            for (const std::size_t i : indices) {
                variance += variances[i] / count;
                time += seconds[i] / count;
            }
            return 1 / (variance * time);
        });
        result.budgets.push_back(budget);
    }

    void check(Result &result) const {
        const Estimate all = mean_picture(by_budget.rbegin()->second);
        for (const auto &pixel : all.mean)
            for (const float value : pixel) result.passes &= std::isfinite(value);
        if (!all.has_noise() || !reference.picture.has_noise()) return;
        const compare::Verdict verdict = compare::test(all, reference.picture, check_alpha);
        result.p = verdict.p;
        result.passes &= !verdict.different();
    }

    void fit(Result &result) const {
        std::vector<double> seconds, errors;
        for (const Budget &budget : result.budgets) {
            seconds.push_back(budget.seconds);
            errors.push_back(budget.relmse);
        }
        result.power = fit_power(seconds, errors);
        const std::size_t seeds = by_budget.begin()->second.size();
        result.slope = bootstrap(seeds, [&](std::span<const std::size_t> indices) {
            std::vector<double> time(seconds.size()), error(seconds.size());
            for (std::size_t b = 0; b < seconds.size(); ++b)
                for (const std::size_t i : indices) {
                    const Distance &d = result.distances[b * seeds + i];
                    time[b] += d.seconds / double(seeds);
                    error[b] += (d.relmse - noise) / double(seeds);
                }
            return fit_power(time, error).slope;
        });
    }
};

} // namespace

Result analyse(const Series &series, const Reference &reference) { return Analysis(series, reference).result(); }

void compare_with(const Result &base, std::vector<Result> &results) {
    const double time = std::log(base.largest().seconds), error = base.power.at(time);
    for (Result &result : results) {
        result.equal_time = std::exp(result.power.at(time) - error);
        result.equal_error = std::exp((error - result.power.intercept) / result.power.slope - time);
    }
}

Interval gain(const Result &a, const Result &b, double Distance::*clock) {
    const auto cost_of = [clock](const Result &result, std::span<const std::size_t> indices) {
        const std::size_t first = result.distances.size() - indices.size();
        double variance = 0, seconds = 0;
        for (const std::size_t i : indices) {
            variance += result.distances[first + i].variance;
            seconds += result.distances[first + i].*clock;
        }
        return variance * seconds;
    };
    const std::size_t seeds_a = a.distances.size() / a.budgets.size(), seeds_b = b.distances.size() / b.budgets.size();
    const std::size_t seeds = std::min(seeds_a, seeds_b);
    return bootstrap(2 * seeds, [&](std::span<const std::size_t> indices) {
        // Two independent draws out of one: the first half picks among a's seeds, the second among b's.
        std::vector<std::size_t> of_a, of_b;
        for (std::size_t i = 0; i < seeds; ++i) {
            of_a.push_back(indices[i] % seeds);
            of_b.push_back(indices[seeds + i] % seeds);
        }
        return cost_of(b, of_b) / cost_of(a, of_a);
    });
}

} // namespace nacre::bench
