#include "oracle/reference_texture.h"
#include <Imath/half.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace nacre::reference {
namespace {

using std::numbers::pi;

/// Bilinear mean of `texel(x, y)` about (x, y), in texels; the middle of the first is at (.5, .5).
template <typename Texel> Vec3 bilinear(double x, double y, const Texel &texel) {
    const double left = std::floor(x - 0.5), top = std::floor(y - 0.5), s = x - 0.5 - left, t = y - 0.5 - top;
    const auto i = std::int64_t(left), j = std::int64_t(top);
    return (1 - t) * ((1 - s) * texel(i, j) + s * texel(i + 1, j)) +
           t * ((1 - s) * texel(i, j + 1) + s * texel(i + 1, j + 1));
}

std::int64_t repeated(std::int64_t i, std::int64_t count) { return (i % count + count) % count; }

} // namespace

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

Vec3 environment_at(const scene::Light &light, const Vec3 &direction) {
    const double azimuth = std::atan2(direction.z(), direction.x()) + light.rotate * pi / 180;
    const double u = 0.5 + azimuth / (2 * pi), v = std::acos(std::clamp(direction.y(), -1.0, 1.0)) / pi;
    const auto texel = [&](std::int64_t x, std::int64_t y) -> Vec3 {
        const std::int64_t row = std::clamp<std::int64_t>(y, 0, light.height - 1);
        const float *rgb = &light.pixels[std::size_t(3 * (row * light.width + repeated(x, light.width)))];
        return {rgb[0], rgb[1], rgb[2]};
    };
    return light.radiance.cwiseProduct(bilinear(u * light.width, v * light.height, texel));
}

} // namespace nacre::reference
