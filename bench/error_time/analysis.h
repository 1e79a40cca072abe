#pragma once
#include "error_time/figures.h"
#include "error_time/shots.h"
#include <optional>

namespace nacre::bench {

/// How far one picture is from what it should be.
struct Distance {
    std::uint32_t spp = 0, seed = 0;
    double seconds = 0, cpu = 0;
    double mse = 0, relmse = 0; // of compare/metrics.h, to the reference
    double worst = 0;           // 99.9th percentile of its pixels' relative errors, each of its worst channel
    double flip = 0;            // mean
    double variance = 0;        // relative like relmse, but to the mean of its seeds: no reference's noise is in it
    double level = 0;           // mean of all values
};

/// All seeds of one budget. Means over them, none left out.
struct Budget {
    std::uint32_t spp = 0;
    double seconds = 0, cpu = 0, mse = 0, flip = 0;
    double relmse = 0;   // what the reference's own noise adds to it taken off
    double worst = 0;    // as in Distance, of the pixels of all pictures together
    double bias = 0;     // relative: mean level over the reference's, less 1
    double bias_z = 0;   // in standard errors of both
    Interval efficiency; // 1 / (relative variance x seconds)
};

struct Result {
    std::string name;
    render::Startup startup;
    std::vector<Distance> distances;
    std::vector<Budget> budgets;
    std::optional<double> p; // of compare's test of all pictures of the largest budget against the reference
    bool passes = true;      // it, and every number is finite: else there is no score
    Line power;              // log relmse over log seconds
    Interval slope;          // of it
    // At the seconds, and at the relmse, of the default's largest budget: what this one's power law says.
    double equal_time = 1;  // relmse over the default's
    double equal_error = 1; // seconds over the default's

    const Budget &largest() const { return budgets.back(); }
};

/// How often a mode that is right fails the check.
constexpr double check_alpha = 1e-4;

/// Every budget needs the same seeds, two or more, and there must be two budgets.
Result analyse(const Series &series, const Reference &reference);

/// Fills equal_time and equal_error; `base`, which may be among them, is what they are held against.
void compare_with(const Result &base, std::vector<Result> &results);

/// Efficiency of `a` over that of `b`, at their largest budgets, with seeds drawn independently, by one of the clocks:
/// `cpu` does not count what else the machine did, `seconds` is what a user waits.
Interval gain(const Result &a, const Result &b, double Distance::*clock);

} // namespace nacre::bench
