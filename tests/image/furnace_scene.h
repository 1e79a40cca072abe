#pragma once
#include "image/rendered.h"
#include <string>

namespace nacre {

/// A white body in a white sky: what the material and the picture are, as JSON where it is not a number.
struct Furnace {
    std::string mesh;                                                                            // whole path
    std::string camera = R"("position": [-1.7, 2.5, 5.1], "target": [0, 0.88, 0.1], "fov": 25)"; // the bear's
    double radius = 0.065;
    std::string radius_scale = "1";
    double g = 0, bleed = 0;
    const char *flight = "renewal", *sampling = "hero";
    const char *guiding = "none"; // guided walks vary about 1, by 1e-4 where nothing is absorbed
    double specular = 0;
    const char *smooth = "false";
    std::string more = {}; // of the material, with a comma before it
    int size = 40, spp = 16;
};

scene::Scene scene_of(const Furnace &furnace);

/// Every sample exactly 1, but for rounding: no pixel may differ by more than 1e-4. No walk is lost.
void expect_exactly_white(const Furnace &furnace);

/// Where samples vary: the mean of every channel within 4 standard errors of 1, and the error at most `largest_error`.
void expect_white_mean(const Furnace &furnace, double largest_error);

/// Calls `check` for all flight laws (exponential, renewal and reciprocal at bleed .5 and 1) and g of 0 and .8.
template <typename Check> void for_all_media(Furnace furnace, Check check) {
    for (const double g : {0., .8})
        for (const auto &[flight, bleed] :
             {std::pair{"renewal", 0.}, {"renewal", .5}, {"renewal", 1.}, {"reciprocal", .5}, {"reciprocal", 1.}}) {
            furnace.g = g;
            furnace.flight = flight;
            furnace.bleed = bleed;
            check(furnace);
        }
}

} // namespace nacre
