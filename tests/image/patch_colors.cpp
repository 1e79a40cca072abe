// The colour asked for is the colour that a patch shows: the inversion through the real renderer.
#include "image/rendered.h"
#include "patch/patch.h"
#include "scene/scene.h"
#include <Imath/half.h>
#include <cmath>
#include <gtest/gtest.h>

namespace nacre {
namespace {

using namespace shared;

struct Case {
    double g, bleed;
    FlightLaw flight = FLIGHT_RENEWAL;
    Entry entry = ENTRY_LAMBERT;
    Vec3 color{.8, .5, .2};
};

scene::Material material_of(const Case &c) {
    scene::Material material;
    material[PARAMETER_subsurface_color].value = c.color;
    material[PARAMETER_subsurface_scatter_anisotropy].value = Vec3::Constant(c.g);
    material[PARAMETER_subsurface_bleed].value = Vec3::Constant(c.bleed);
    material.flight = c.flight;
    material.entry = c.entry;
    return material;
}

// Within four standard errors, and 2e-5 for the table. Flights with bleed leave a box of half a million mean free paths
// now and then: 2e-6 of them at bleed 1, times the scatters of a walk of the brightest colour, some 1,000.
void expect_colors(const Case &c, double error) {
    const patch::Color found = patch::measure(device::open_device(), material_of(c), error);
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(found.value[k], c.color[Eigen::Index(k)], 4 * found.error[k] + 2e-5)
            << "g " << c.g << ", bleed " << c.bleed << ", flight " << c.flight << ", entry " << c.entry;
}

TEST(PatchColors, AreThoseAskedFor) {
    for (const Case &c : {Case{0, 0},
                          {.8, 0},
                          {-.5, .5},
                          {.8, .5},
                          {.9, 1},
                          {.5, .5, FLIGHT_RECIPROCAL},
                          {.7, 0, FLIGHT_RENEWAL, ENTRY_UNIFORM}})
        expect_colors(c, 1e-3);
}

// 21 media of three colours each.
TEST(LongPatchColors, AreThoseAskedFor) {
    const Vec3 colors[] = {{.8, .5, .2}, {.9, .7, .05}, {.95, .35, .6}};
    int i = 0;
    for (const auto flight : {FLIGHT_RENEWAL, FLIGHT_RECIPROCAL})
        for (const double bleed : {0., .25, .7})
            for (const double g : {-.6, .3, .85})
                expect_colors({g, bleed, flight, ENTRY_LAMBERT, colors[i++ % 3]}, 1e-4);
    for (const double g : {0., .5, .9}) expect_colors({g, .4, FLIGHT_RENEWAL, ENTRY_UNIFORM, colors[i++ % 3]}, 1e-4);
}

// A texture of one colour is that colour: the kernels' table gives the albedo that the host does, to 1e-5 in colour.
// With g and bleed from textures, too, the table has all its axes.
TEST(PatchColors, OfTexturesToo) {
    for (const bool all : {false, true}) {
        const Case c{.6, all ? .3 : 0};
        scene::Scene scene = patch::patch_scene(material_of(c), 5e5, 64);
        const auto paint = [&](Parameter p, const Vec3 &value) {
            scene::Image &image = scene.images.emplace_back();
            image.width = image.height = 1;
            image.channels = 4;
            for (int k = 0; k < 3; ++k) image.halves.push_back(Imath::half(float(value[k])).bits());
            image.halves.push_back(Imath::half(1.0f).bits());
            scene.materials[0][p].texture = int(scene.textures.size());
            scene.textures.push_back(
                {.image = std::uint32_t(scene.images.size() - 1), .channel = p == PARAMETER_subsurface_color ? -1 : 0});
        };
        paint(PARAMETER_subsurface_color, c.color);
        if (all) {
            paint(PARAMETER_subsurface_scatter_anisotropy, Vec3::Constant(c.g));
            paint(PARAMETER_subsurface_bleed, Vec3::Constant(c.bleed));
        }
        scene.render.spp = 256;
        const patch::Color found = patch::mean_color(rendered(scene).picture);
        for (std::size_t k = 0; k < 3; ++k) // half floats: 11 bits
            EXPECT_NEAR(found.value[k], c.color[Eigen::Index(k)], 4 * found.error[k] + 5e-4) << "all " << all;
    }
}

} // namespace
} // namespace nacre
