#include "oracle/reference_texture.h"
#include "oracle/reference_bilinear.h"
#include <Imath/half.h>

namespace nacre::reference {

Vec3 texture_at(const scene::Scene &scene, std::uint32_t index, const Vec2 &uv) {
    const scene::Texture &texture = scene.textures[index];
    const scene::Image &image = scene.images[texture.image];
    const auto texel = [&](std::int64_t x, std::int64_t y) -> Vec3 {
        const std::size_t at = std::size_t(repeated(y, image.height) * image.width + repeated(x, image.width));
        const auto number = [&](std::size_t channel) {
            Imath::half value;
            value.setBits(image.halves[at * image.channels + channel]);
            return double(value);
        };
        if (image.channels == 1) return Vec3::Constant(number(0));
        if (texture.channel >= 0) return Vec3::Constant(number(std::size_t(texture.channel)));
        return {number(0), number(1), number(2)};
    };
    const Vec2 at = uv.cwiseProduct(texture.scale) + texture.offset;
    return bilinear(at.x() * image.width, (1 - at.y()) * image.height, texel);
}

} // namespace nacre::reference
