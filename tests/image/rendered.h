#pragma once
#include "io/image.h"
#include "io/load.h"
#include "render/session.h"
#include <array>
#include <string>
#include <vector>

namespace nacre {

/// A picture and what it took.
struct Rendered {
    io::Picture picture;
    render::Statistics statistics;

    float at(int x, int y, std::size_t channel) const;
};

/// Walks side by side that the default device may be asked for: a GPU's work-items are lanes already, it has one.
std::vector<int> lane_counts();

/// A mean over pixels and its standard error (pixels are independent: each has its own scrambling).
struct Mean {
    double value = 0, error = 0;
};

/// The scene of this nacre JSON. Meshes are named by whole paths.
scene::Scene scene_of(const std::string &json);

/// Renders on the default device, which all tests of a process share.
Rendered rendered(const scene::Scene &scene, const render::Options &options = {});

/// Expects two pictures equal to the bit in all layers, and not black.
void expect_same_pixels(const io::Picture &a, const io::Picture &b);

/// Mean of R, G and B over the pixels that geometry covers wholly (alpha 1).
std::array<Mean, 3> covered_mean(const io::Picture &picture);

/// Renders seed after seed until the standard error of every channel is at most its `largest_error`.
std::array<Mean, 3> rendered_to(scene::Scene scene, const std::array<double, 3> &largest_error);

} // namespace nacre
