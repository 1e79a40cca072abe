#include "oracle/reference.h"
#include "base/parallel.h"
#include "oracle/reference_camera.h"
#include "oracle/reference_known.h"
#include "oracle/reference_path.h"

namespace nacre::reference {

Image render(const scene::Scene &scene, std::uint32_t samples, std::uint64_t seed) {
    expect_known(scene);
    const World world(scene);
    Image image{scene.image.width, scene.image.height, {}, {}};
    const std::size_t pixels = std::size_t(image.width) * std::size_t(image.height);
    image.mean.resize(3 * pixels);
    image.variance.resize(3 * pixels);
    parallel_for(pixels, [&](std::size_t pixel) {
        Random random(seed, pixel);
        for (int channel = 0; channel < 3; ++channel) {
            double mean = 0, squares = 0; // squares: of deviations, Welford 1962
            for (std::uint32_t i = 0; i < samples; ++i) {
                const Ray ray = camera_ray(world, int(pixel) % image.width, int(pixel) / image.width, random);
                const double value = Path(world, channel, random).trace(ray), deviation = value - mean;
                mean += deviation / (i + 1);
                squares += deviation * (value - mean);
            }
            image.mean[3 * pixel + std::size_t(channel)] = mean;
            image.variance[3 * pixel + std::size_t(channel)] = squares / (samples - 1.0) / samples;
        }
    });
    return image;
}

} // namespace nacre::reference
