// Directions from an environment image: texels by their share of the light, and the density that goes with them.
#include "device/chi_square.h"
#include "device/light_probe.h"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace nacre::test {
namespace {

using namespace shared;
using std::numbers::pi;

constexpr std::uint32_t samples = 1 << 21, width = 16, height = 8;

scene::Scene scene_under_image(double rotate) {
    scene::Scene scene = scene_with_box();
    scene::Light sky;
    sky.kind = LIGHT_ENVIRONMENT_IMAGE;
    sky.width = width;
    sky.height = height;
    sky.rotate = rotate;
    sky.radiance = {2, 1, 1};
    for (std::uint32_t i = 0; i < width * height; ++i)
        for (std::uint32_t c = 0; c < 3; ++c)
            sky.pixels.push_back(i == 37 ? 20.f : i % 11 == 3 ? 0.f : .2f + float((i * 7 + c * 3) % 10) * .1f);
    scene.lights = {sky};
    return scene;
}

/// Texel coordinates by the convention of design.md: u = 1/2 + atan2(z, x) / 2 pi, row 0 at +y, turned about +y.
Vec2 coordinates(const Vec3 &world, double rotate) {
    const double t = rotate * pi / 180;
    const Vec3 d = Eigen::AngleAxisd(-t, Vec3::UnitY()) * world;
    return {width * (.5 + std::atan2(d.z(), d.x()) / (2 * pi)),
            height * std::atan2(std::hypot(d.x(), d.z()), d.y()) / pi};
}

double interpolated(const scene::Light &sky, const Vec2 &at, std::uint32_t channel) {
    const double x = at.x() - .5, y = std::clamp(at.y() - .5, 0.0, double(height - 1));
    const auto texel = [&](int i, int j) {
        return double(sky.pixels[3 * (std::size_t(std::min(j, int(height) - 1)) * width +
                                      std::size_t((i + int(width)) % int(width))) +
                                 channel]);
    };
    const int i = int(std::floor(x)), j = int(y);
    const double s = x - i, t = y - j;
    return sky.radiance[channel] * ((1 - t) * ((1 - s) * texel(i, j) + s * texel(i + 1, j)) +
                                    t * ((1 - s) * texel(i, j + 1) + s * texel(i + 1, j + 1)));
}

TEST(EnvironmentSampling, TexelsByTheirLightEvenlyWithin) {
    for (const double rotate : {0.0, 77.0}) {
        const scene::Scene scene = scene_under_image(rotate);
        const scene::Light &sky = scene.lights[0];
        constexpr std::size_t parts = 20;           // per texel and side
        std::vector<double> shares(width * height); // of the picture's interpolated luminance, by quadrature
        Vec3 total(0, 0, 0);
        for (std::size_t j = 0; j < height * parts; ++j)
            for (std::size_t i = 0; i < width * parts; ++i) {
                const Vec2 at((double(i) + .5) / parts, (double(j) + .5) / parts);
                const double v = pi / height, solid_angle = 2 * pi / width * v * std::sin(at.y() * v) / (parts * parts);
                Vec3 radiance;
                for (std::uint32_t c = 0; c < 3; ++c) radiance[c] = interpolated(sky, at, c);
                total += radiance * solid_angle;
                // Texels are drawn by the picture's own luminance, before its scale; and by their solid angle as a
                // whole.
                const double row = (std::cos(std::floor(at.y()) * v) - std::cos((std::floor(at.y()) + 1) * v)) / v;
                shares[std::size_t(at.y()) * width + std::size_t(at.x())] +=
                    row * (.2126 * radiance.x() / 2 + .7152 * radiance.y() + .0722 * radiance.z());
            }

        const std::vector<LightDraw> draws = draw_lights(scene, {0, 2, 0}, {0, 1, 0}, samples, 5);
        std::vector<std::uint64_t> observed(width * height);
        std::vector<double> x, y;
        Vec3 sum(0, 0, 0), squares(0, 0, 0);
        double inverse = 0, inverse2 = 0;
        for (const LightDraw &draw : draws) {
            const Vec2 at = coordinates(draw.direction, rotate);
            const auto i = std::min(std::size_t(width - 1), std::size_t(at.x())),
                       j = std::min(std::size_t(height - 1), std::size_t(at.y()));
            ++observed[j * width + i];
            x.push_back(at.x() - double(i));
            y.push_back(at.y() - double(j));
            sum += draw.radiance;
            squares += draw.radiance.cwiseAbs2();
            inverse += 1 / draw.density;
            inverse2 += 1 / (draw.density * draw.density);
            ASSERT_NEAR(draw.texel.x(), at.x(), 1e-4);
            ASSERT_NEAR(draw.texel.y(), at.y(), 1e-4);
            // At a texel's edge the next one may be asked.
            if (std::min(x.back(), y.back()) > 1e-3 && std::max(x.back(), y.back()) < .999) {
                // The solid angle of a texel goes to 0 at the poles: so many digits as that has.
                ASSERT_NEAR(draw.density_again / draw.density, 1, 1e-5 + 2e-6 / std::sin(pi * at.y() / height));
            }
            for (std::uint32_t c = 0; c < 3; ++c) {
                ASSERT_NEAR(draw.radiance_again[c], interpolated(sky, at, c), 2e-3);
                ASSERT_NEAR(draw.radiance[c] * draw.density, interpolated(sky, at, c), 2e-3);
            }
        }
        expect_distribution(observed, shares, "texels");
        expect_uniform(x, y, 32, "within texels");
        const double n = samples, mean = inverse / n;
        EXPECT_NEAR(mean, 4 * pi, 4 * std::sqrt((inverse2 / n - mean * mean) / n)) << "the density is normalised";
        for (int c = 0; c < 3; ++c) {
            const double m = sum[c] / n;
            EXPECT_NEAR(m, total[c], 4 * std::sqrt((squares[c] / n - m * m) / n) + 1e-3 * total[c]);
        }
    }
}

} // namespace
} // namespace nacre::test
