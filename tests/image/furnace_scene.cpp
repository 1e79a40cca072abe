#include "image/furnace_scene.h"
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace nacre {
namespace {

std::string describe(const Furnace &f) {
    return fmt::format("{} bleed {} g {} {} radius scale {} specular {} smooth {}{}", f.flight, f.bleed, f.g,
                       f.sampling, f.radius_scale, f.specular, f.smooth, f.more);
}

// Nothing is lost, and hardly a walk slips through the surface (by rounding, where an edge is grazed).
void expect_no_loss(const render::Statistics &statistics) {
    EXPECT_EQ(statistics[shared::COUNTER_non_finite], 0u);
    EXPECT_EQ(statistics[shared::COUNTER_escaped], 0u);
    EXPECT_LE(double(statistics[shared::COUNTER_missed]), 1e-4 * double(statistics[shared::COUNTER_walks]));
}

} // namespace

scene::Scene scene_of(const Furnace &f) {
    return scene_of(fmt::format(
        R"({{"camera": {{{}}}, "image": {{"width": {}, "height": {}}},
             "render": {{"spp": {}, "max_depth": 0, "channel_sampling": "{}", "guiding": "{}"}},
             "materials": {{"white": {{"subsurface_weight": 1, "subsurface_albedo": 1, "subsurface_radius": {},
               "subsurface_radius_scale": {}, "subsurface_scatter_anisotropy": {}, "subsurface_bleed": {},
               "subsurface_flight": "{}", "specular_weight": {}{}}}}},
             "objects": [{{"mesh": "{}", "material": "white", "smooth": {}}}],
             "lights": [{{"type": "environment", "radiance": 1}}]}})",
        f.camera, f.size, f.size, f.spp, f.sampling, f.guiding, f.radius, f.radius_scale, f.g, f.bleed, f.flight,
        f.specular, f.more, f.mesh, f.smooth));
}

void expect_exactly_white(const Furnace &furnace) {
    SCOPED_TRACE(describe(furnace));
    const Rendered found = rendered(scene_of(furnace));
    double worst = 0, covered = 0;
    for (int y = 0; y < furnace.size; ++y)
        for (int x = 0; x < furnace.size; ++x) {
            covered += found.at(x, y, 3) / (double(furnace.size) * furnace.size);
            for (std::size_t c = 0; c < 3; ++c) worst = std::max(worst, std::abs(found.at(x, y, c) - 1.0));
        }
    EXPECT_LE(worst, 1e-4);
    EXPECT_GT(covered, 0.2) << "the camera must see the body";
    expect_no_loss(found.statistics);
}

void expect_white_mean(const Furnace &furnace, double largest_error) {
    SCOPED_TRACE(describe(furnace));
    const Rendered found = rendered(scene_of(furnace));
    for (const Mean &mean : covered_mean(found.picture)) {
        EXPECT_NEAR(mean.value, 1, 4 * mean.error + 1e-5) << "standard error " << mean.error;
        EXPECT_LE(mean.error, largest_error);
    }
    expect_no_loss(found.statistics);
}

} // namespace nacre
