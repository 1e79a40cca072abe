#include "scene/mean.h"
#include <Imath/half.h>

namespace nacre::scene {

Vec3 mean_color(const Scene &scene, const Value &value) {
    if (value.texture < 0) return value.value;
    const Texture &texture = scene.textures[value.texture];
    const Image &image = scene.images[texture.image];
    const std::size_t pixels = std::size_t(image.width) * image.height;
    Vec3 sum{0, 0, 0};
    for (std::size_t i = 0; i < pixels; ++i)
        for (std::uint32_t c = 0; c < 3; ++c) {
            const std::uint32_t channel = image.channels == 1 ? 0 : texture.channel >= 0 ? texture.channel : c;
            Imath::half h;
            h.setBits(image.halves[i * image.channels + channel]);
            sum[c] += h;
        }
    return sum / double(pixels);
}

} // namespace nacre::scene
