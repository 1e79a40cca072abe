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

// Within four standard errors, and 2e-5 for the table; in standard errors. Flights with bleed leave a box of half a
// million mean free paths now and then: 2e-6 of them at bleed 1, times the scatters of a walk of the brightest colour,
// some 1,000.
std::array<double, 3> expect_colors(const Case &c, double error) {
    const patch::Color found = patch::measure(device::open_device(), material_of(c), error);
    std::array<double, 3> z{};
    for (std::size_t k = 0; k < 3; ++k) {
        const double off = found.value[k] - c.color[Eigen::Index(k)];
        EXPECT_NEAR(off, 0, 4 * found.error[k] + 2e-5)
            << "color " << c.color[Eigen::Index(k)] << ", g " << c.g << ", bleed " << c.bleed << ", flight " << c.flight
            << ", entry " << c.entry;
        z[k] = off / found.error[k];
    }
    return z;
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

// 21 media of three colours each: darker ones where walks are long or bleed makes their weights differ, so that all of
// it takes a quarter of an hour on two cores.
TEST(LongPatchColors, AreThoseAskedFor) {
    const Vec3 bright{.9, .7, .05}, light{.75, .5, .2}, middle{.65, .4, .15}, dark{.5, .25, .05};
    const Case cases[] = {
        {-.6, 0, FLIGHT_RENEWAL, ENTRY_LAMBERT, light},       {.3, 0, FLIGHT_RENEWAL, ENTRY_LAMBERT, bright},
        {.85, 0, FLIGHT_RENEWAL, ENTRY_LAMBERT, light},       {-.6, .25, FLIGHT_RENEWAL, ENTRY_LAMBERT, middle},
        {.3, .25, FLIGHT_RENEWAL, ENTRY_LAMBERT, light},      {.85, .25, FLIGHT_RENEWAL, ENTRY_LAMBERT, middle},
        {-.6, .7, FLIGHT_RENEWAL, ENTRY_LAMBERT, dark},       {.3, .7, FLIGHT_RENEWAL, ENTRY_LAMBERT, dark},
        {.85, .7, FLIGHT_RENEWAL, ENTRY_LAMBERT, dark},       {-.6, .1, FLIGHT_RECIPROCAL, ENTRY_LAMBERT, light},
        {.3, .1, FLIGHT_RECIPROCAL, ENTRY_LAMBERT, bright},   {.85, .1, FLIGHT_RECIPROCAL, ENTRY_LAMBERT, middle},
        {-.6, .25, FLIGHT_RECIPROCAL, ENTRY_LAMBERT, middle}, {.3, .25, FLIGHT_RECIPROCAL, ENTRY_LAMBERT, light},
        {.85, .25, FLIGHT_RECIPROCAL, ENTRY_LAMBERT, dark},   {-.6, .7, FLIGHT_RECIPROCAL, ENTRY_LAMBERT, dark},
        {.3, .7, FLIGHT_RECIPROCAL, ENTRY_LAMBERT, middle},   {.85, .7, FLIGHT_RECIPROCAL, ENTRY_LAMBERT, dark},
        {0, .4, FLIGHT_RENEWAL, ENTRY_UNIFORM, middle},       {.5, .4, FLIGHT_RENEWAL, ENTRY_UNIFORM, middle},
        {.9, .4, FLIGHT_RENEWAL, ENTRY_UNIFORM, dark}};
    double largest = 0, squares = 0;
    for (const Case &c : cases) {
        const std::array<double, 3> z = expect_colors(c, 1e-4);
        for (const double value : z) {
            largest = std::max(largest, std::abs(value));
            squares += value * value;
        }
    }
    printf("[ patches  ] %zu colours, |z| at most %.1f, %.2f in the root mean square\n", 3 * std::size(cases), largest,
           std::sqrt(squares / double(3 * std::size(cases))));
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
