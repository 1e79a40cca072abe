// A million samples lose nothing: the mean is that of the samples, rounded once.
#include "image/light_scene.h"
#include "image/rendered.h"
#include <bit>
#include <cmath>
#include <gtest/gtest.h>

namespace nacre {
namespace {

// What a block of 64 samples loses every block does: a tenth of a million shows it, too.
constexpr std::uint32_t million = 1000000, some = 99983;

/// One pixel that looks past everything into a sky.
scene::Scene sky_pixel(const Vec3 &radiance, std::uint32_t spp) {
    scene::Scene scene = floor_scene();
    scene.lights = {constant_sky(radiance)};
    scene.lights[0].visible = true;
    scene.camera.position = {0, 5, 0};
    scene.camera.target = {0, 6, 0};
    scene.camera.up = {0, 0, 1};
    scene.image = {1, 1};
    scene.render.spp = spp;
    return scene;
}

int ulps_between(float a, float b) { return std::abs(std::bit_cast<int>(a) - std::bit_cast<int>(b)); }

// Every sample has the same float (a third of the film's unit and its like): any loss would repeat 1e6 times.
void check_constant(const std::vector<std::uint32_t> &counts) {
    for (const std::uint32_t spp : counts) {
        const Vec3 radiance(1. / 3, 1. / 7, 1e-3);
        const Rendered found = rendered(sky_pixel(radiance, spp));
        const Rendered one = rendered(sky_pixel(radiance, 1));
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_LE(ulps_between(found.at(0, 0, c), one.at(0, 0, c)), 1) << spp << " samples";
            EXPECT_NEAR(found.at(0, 0, c) / radiance[Eigen::Index(c)], 1, 3e-7) << spp << " samples";
        }
    }
}

TEST(FilmSums, AConstantIsItself) { check_constant({7, 64, 1000, some}); }
TEST(LongFilmSums, AConstantIsItself) { check_constant({million - 17, million}); }

// A white patch covers part of the pixel before a sky a million times darker: the mean is share x 1 + (1 - share) x
// 1e-6, and alpha is the share itself, a count. Adding small to large in float would lose the sky's part, 2^-20 of a
// sum of 32 and more.
void check_small_beside_large(std::uint32_t spp) {
    scene::Scene scene = sky_pixel(Vec3::Constant(1e-6), spp);
    scene.objects.clear();
    scene.materials.resize(1);
    scene.materials[0][shared::PARAMETER_base_color].value = Vec3::Zero();
    scene.materials[0][shared::PARAMETER_specular_weight].value = Vec3::Zero();
    add_emitter(scene, quad({-.5, 6, -.5}, {.4, 0, 0}, {0, 0, 1}), {1, 1, 1});
    scene.camera.height = 1;
    const Rendered found = rendered(scene);
    const double share = double(found.at(0, 0, 3));
    EXPECT_GT(share, .1);
    EXPECT_LT(share, .9);
    EXPECT_NEAR(found.at(0, 0, 0), share + (1 - share) * 1e-6, 1.2e-7 * share);
}

TEST(FilmSums, SmallBesideLarge) { check_small_beside_large(some); }
TEST(LongFilmSums, SmallBesideLarge) { check_small_beside_large(million); }

} // namespace
} // namespace nacre
