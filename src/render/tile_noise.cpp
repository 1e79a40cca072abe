#include "render/tile_noise.h"
#include <algorithm>
#include <cmath>

namespace nacre::render {
namespace {

/// How much of the spread of a tile's means is of what they show, and not noise (empirical Bayes: Efron & Morris 1973,
/// "Stein's Estimation Rule and its Competitors").
double share_shown(double spread, double noise) { return spread > noise ? 1 - noise / spread : 0; }

} // namespace

double noise_floor(double level) { return 0.01 * level * level; }

double relative_noise(std::span<const MeasuredPixel> tile, double floor) {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const auto finite = [c](const MeasuredPixel &pixel) {
            return std::isfinite(pixel.mean[c]) && std::isfinite(pixel.variance[c]);
        };
        double count = 0, mean = 0, noise = 0, spread = 0;
        for (const MeasuredPixel &pixel : tile)
            if (finite(pixel)) {
                count += 1;
                mean += pixel.mean[c];
                noise += pixel.variance[c];
            }
        if (!(noise > 0)) continue;
        mean /= count;
        for (const MeasuredPixel &pixel : tile)
            if (finite(pixel)) spread += (pixel.mean[c] - mean) * (pixel.mean[c] - mean) / std::max(1.0, count - 1);
        // A pixel's own mean would be large just where its variance is, where few samples met what is rare and bright:
        // v / m^2 never is more than the number of samples. So it counts by what it is known to differ from the tile's.
        const double shown = share_shown(spread, noise / count);
        for (const MeasuredPixel &pixel : tile)
            if (finite(pixel)) {
                const double near = mean + shown * (pixel.mean[c] - mean);
                if (pixel.variance[c] > 0) sum += pixel.variance[c] / (near * near + floor) / 3;
            }
    }
    return sum;
}

} // namespace nacre::render
