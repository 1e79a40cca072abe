#pragma once
#include "patch/patch.h"
#include <filesystem>

namespace nacre::patch {

/// Colours that walks without a cap show for given albedos and anisotropies (bleed 0, lambert entry), by rendering.
struct Survey {
    struct Point {
        double g, albedo, color, error; // error: standard error of the colour
    };
    std::vector<Point> points;
};

/// 40 anisotropies in [0, .95] times 40 albedos, evenly spaced in similarity, as in the memo's section 6. What `file`
/// has from an earlier run is not rendered again, what is new is appended to it line by line: a survey can be stopped
/// at any time. `report` is told the share that is done and may throw to stop. Throws Error{Exit::input} where the file
/// is something else, Error{Exit::output} where it cannot be written.
Survey survey_albedos(const device::Device &device, const std::filesystem::path &file,
                      const std::function<void(double)> &report);

} // namespace nacre::patch
