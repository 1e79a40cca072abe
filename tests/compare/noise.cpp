#include "compare/noise.h"
#include <algorithm>
#include <cmath>
#include <random>

namespace nacre {
namespace {

using Random = std::mt19937_64;

double uniform(Random &random) { return double(random() >> 11) * 0x1p-53; }

/// Six laws, of mean about 1.
double sample(int law, Random &random) {
    const double u = uniform(random);
    switch (law) {
    case 0: return 1;                                                         // a background: no noise at all
    case 1: return u < 0.5 ? 0.5 : 1.5;                                       // an edge between two even surfaces
    case 2: return u < 0.9 ? 0.6 + 0.02 * uniform(random) : 4.5;              // seldom a light
    case 3: return u < 0.995 ? 0.5 + 0.5 * uniform(random) : 60;              // fireflies
    case 4: return 0.45 / std::pow(1 - u, 1 / 1.8);                           // a power law without a variance
    default: return std::exp(1.5 * std::normal_distribution<>()(random)) / 3; // lognormal
    }
}

} // namespace

compare::Estimate noisy(const Noise &noise, int spp, std::uint64_t seed) {
    compare::Estimate picture;
    picture.width = noise.width;
    picture.height = noise.height;
    picture.level = 1;
    Random random(seed);
    for (int pixel = 0; pixel < noise.width * noise.height; ++pixel) {
        auto &mean = picture.mean.emplace_back();
        auto &variance = picture.variance.emplace_back();
        picture.samples.push_back(float(spp));
        const int law = pixel * 7 % 11 % 6;
        for (std::size_t c = 0; c < 3; ++c) {
            double sum = 0, squares = 0;
            for (int i = 0; i < spp; ++i) {
                const double value = noise.brighter * sample(law, random);
                sum += value;
                squares += value * value;
            }
            const double m = sum / spp;
            mean[c] = float(m);
            variance[c] = spp > 1 ? float(std::max(0.0, squares / spp - m * m) / (spp - 1)) : 0;
        }
    }
    return picture;
}

} // namespace nacre
