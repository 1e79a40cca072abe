#include "error_time/shots.h"
#include "app/interrupt.h"
#include "error_time/figures.h"
#include "measure.h"
#include <cmath>
#include <fmt/format.h>

namespace nacre::bench {
namespace {

// Samples per pixel that decide whether a clearance field pays: at these sizes as many as a picture of 512 x 512 has
// with its 64, since start-up is told apart.
constexpr std::uint32_t worth = 4096;

} // namespace

compare::Estimate mean_of(std::span<const compare::Estimate *const> pictures) {
    const double count = double(pictures.size());
    compare::Estimate mean = *pictures[0];
    for (std::size_t i = 0; i < mean.mean.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            double value = 0, variance = 0;
            for (const compare::Estimate *picture : pictures) {
                value += double(picture->mean[i][c]);
                if (mean.has_noise()) variance += double(picture->variance[i][c]);
            }
            mean.mean[i][c] = float(value / count);
            if (mean.has_noise()) mean.variance[i][c] = float(variance / (count * count));
        }
        if (mean.has_noise())
            for (const compare::Estimate *picture : pictures.subspan(1)) mean.samples[i] += picture->samples[i];
    }
    return mean;
}

Reference reference_of(const std::vector<compare::Estimate> &renders) {
    Reference reference;
    std::vector<const compare::Estimate *> pictures;
    for (const compare::Estimate &render : renders) {
        pictures.push_back(&render);
        reference.level.push_back(level_of(render));
    }
    reference.picture = mean_of(pictures);
    const double count = double(renders.size());
    for (std::size_t i = 0; i < reference.picture.mean.size(); ++i) {
        std::array<double, 3> &variance = reference.variance.emplace_back();
        for (std::size_t c = 0; c < 3; ++c) {
            for (const compare::Estimate &render : renders) {
                const double off = double(render.mean[i][c]) - double(reference.picture.mean[i][c]);
                variance[c] += off * off / (count - 1) / count;
            }
        }
    }
    return reference;
}

double level_of(const compare::Estimate &picture) {
    double sum = 0;
    for (const auto &pixel : picture.mean) sum += double(pixel[0]) + double(pixel[1]) + double(pixel[2]);
    return sum / (3 * double(picture.mean.size()));
}

double noise_of(const compare::Estimate &picture) {
    const double level = level_of(picture);
    double sum = 0;
    for (std::size_t i = 0; i < picture.mean.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const double mean = picture.mean[i][c];
            sum += double(picture.variance[i][c]) / (mean * mean + .01 * level * level);
        }
    return std::sqrt(sum / (3 * double(picture.mean.size())));
}

void take_slopes(std::vector<Shot> &shots, std::size_t budgets, double Shot::*clock) {
    for (std::size_t first = 0; first < shots.size(); first += budgets) {
        const Shot &least = shots[first], &most = shots[first + budgets - 1];
        if (most.taken == least.taken) continue;
        const double a_sample = (most.*clock - least.*clock) / (most.taken - least.taken);
        for (std::size_t i = first; i < first + budgets; ++i) shots[i].*clock = a_sample * shots[i].taken;
    }
}

Shot shoot(const device::Device &device, const scene::Scene &scene, const Mode &mode, std::uint32_t spp,
           std::uint32_t seed, double error, render::Startup *startup) {
    Setup setup{scene, {}, spp, error};
    setup.options.layers.variance = setup.options.layers.samples = true;
    setup.scene.render.seed = seed;
    setup.scene.render.spp = worth;
    mode.apply(setup);
    render::Session session(device, setup.scene, setup.options);
    const Seconds spent = seconds([&] { session.render(setup.spp, {}, &app::interrupted); });
    check_interrupt();
    const render::Statistics statistics = session.statistics();
    if (startup) *startup = statistics.startup;
    const double taken = double(statistics.samples) / scene.image.width / scene.image.height;
    return {spp, seed, statistics.sampling, spent.cpu, taken, compare::estimate_of(session.picture(), mode.name)};
}

Reference make_reference(const device::Device &device, const scene::Scene &scene, std::uint32_t spp, int renders,
                         std::uint32_t first_seed, Pace &pace) {
    std::vector<compare::Estimate> pictures;
    for (int i = 0; i < renders; ++i) {
        pace.next(fmt::format("reference, seed {} of {}", i + 1, renders), spp);
        pictures.push_back(shoot(device, scene, modes().front(), spp, first_seed + std::uint32_t(i), 0).picture);
    }
    return reference_of(pictures);
}

} // namespace nacre::bench
