#pragma once
#include "compare/estimate.h"
#include "device/context.h"
#include "error_time/modes.h"
#include "error_time/pace.h"
#include <array>

namespace nacre::bench {

/// One picture of a scene.
struct Shot {
    std::uint32_t spp = 0, seed = 0;
    double seconds = 0; // of sampling alone
    double cpu = 0;     // of all threads; of the whole picture, until take_slopes
    double taken = 0;   // samples per pixel; spp but where a mode takes what it needs
    compare::Estimate picture;
};

/// Pictures of one scene by one renderer in one mode: every budget with every seed.
struct Series {
    std::string name;
    render::Startup startup; // of the first, in which programs are compiled where no cache has them
    std::vector<Shot> shots;
};

/// What the expected picture is, as far as known: the mean of independent renders.
struct Reference {
    compare::Estimate picture;                   // with the layers variance and samples where the renders have them
    std::vector<std::array<double, 3>> variance; // of the mean, per pixel, from how far the renders lie apart
    std::vector<double> level;                   // of every render: the mean of all its values
};

/// The mean of pictures with other seeds, each with as many samples.
compare::Estimate mean_of(std::span<const compare::Estimate *const> pictures);

/// The mean of all values of a picture.
double level_of(const compare::Estimate &picture);

Reference reference_of(const std::vector<compare::Estimate> &renders);

/// What a picture's own variances say of it: the root of its relMSE.
double noise_of(const compare::Estimate &picture);

/// Turns times of whole pictures, with what is done once per picture, into those of sampling: what a seed's largest
/// budget takes longer than its smallest, per sample; all of it where both take as many. The shots of a seed follow one
/// another, smallest first.
void take_slopes(std::vector<Shot> &shots, std::size_t budgets, double Shot::*clock);

/// Renders. Every call makes a session of its own. `error`: Setup::error. Throws Interrupted.
Shot shoot(const device::Device &device, const scene::Scene &scene, const Mode &mode, std::uint32_t spp,
           std::uint32_t seed, double error, render::Startup *startup = nullptr);

/// `renders` pictures in the default mode, their seeds not below `first_seed`. Throws Interrupted.
Reference make_reference(const device::Device &device, const scene::Scene &scene, std::uint32_t spp, int renders,
                         std::uint32_t first_seed, Pace &pace);

} // namespace nacre::bench
