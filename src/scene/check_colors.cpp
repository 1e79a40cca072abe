#include "scene/check_colors.h"
#include "albedo/inversion.h"
#include "albedo/table.h"
#include <Imath/half.h>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace nacre::scene {
namespace {

using namespace shared;

/// Largest number in the texture of a value, 0 without one.
double brightest(const Scene &scene, const Value &value) {
    if (value.texture < 0) return 0;
    const Image &image = scene.images[scene.textures[std::size_t(value.texture)].image];
    double most = 0;
    for (std::size_t i = 0; i < image.halves.size(); ++i) {
        if (image.channels == 4 && i % 4 == 3) continue; // alpha
        Imath::half h;
        h.setBits(image.halves[i]);
        most = std::max(most, double(h));
    }
    return most;
}

/// A colour, and what comes of it because kernels know its albedo as a float.
struct Rounded {
    double asked, shown;
};

/// Those that albedos next to 1 are too coarse for: off by more than the table is.
std::vector<Rounded> rounded_colors(const Material &material) {
    std::vector<Rounded> found;
    const Value &color = material[PARAMETER_subsurface_color];
    const double bleed = material[PARAMETER_subsurface_bleed].value.x();
    for (int c = 0; c < 3 && color.texture < 0; ++c) {
        const albedo::Medium medium{.anisotropy = material[PARAMETER_subsurface_scatter_anisotropy].value[c],
                                    .bleed = bleed,
                                    .flight = material.flight,
                                    .entry = material.entry};
        const double asked = color.value[c], exact = albedo::albedo(material.inversion, asked, medium);
        if (asked >= 1) continue;
        // Near white 1 - color goes like a power of 1 - albedo (albedo/half_space.h).
        const double power = 1 / (1 + (material.flight == FLIGHT_RECIPROCAL ? std::max(1.0, bleed) : 1.0));
        const double share = exact < 1 ? (1 - double(float(exact))) / (1 - exact) : 0;
        const double shown = 1 - (1 - asked) * std::pow(share, power);
        if (std::abs(shown - asked) > 2e-4) found.push_back({asked, shown});
    }
    return found;
}

} // namespace

std::vector<std::string> check_colors(const Scene &scene, const Material &material) {
    std::vector<std::string> found;
    if (const double most = brightest(scene, material[PARAMETER_subsurface_color]); most > 1)
        found.push_back(fmt::format("its texture of colours reaches {:.3g}; above 1 is taken as 1", most));
    if (material.inversion == INVERSION_NONE || material.model != MODEL_RANDOM_WALK) return found;
    const auto off = [&](const std::string &why) {
        found.push_back(why + "; subsurface_color is then not quite what a flat patch shows");
    };
    if (material.max_depth > 0)
        off(fmt::format("walks end after {} scatters (subsurface_max_depth), which darkens bright colours",
                        material.max_depth));
    if (material.internal_reflection) off("walks are turned back at the surface (subsurface_internal_reflection)");
    if (material.entry == ENTRY_REFRACTED) off("subsurface_entry is refracted, its colours are made for lambert");
    if (material.inversion != INVERSION_TABLE) return found;
    const Vec3 &g = material[PARAMETER_subsurface_scatter_anisotropy].value;
    if (g.minCoeff() < albedo::least_anisotropy || g.maxCoeff() > albedo::largest_anisotropy)
        off(fmt::format("colours are exact for subsurface_scatter_anisotropy from {} to {}", albedo::least_anisotropy,
                        albedo::largest_anisotropy));
    if (material[PARAMETER_subsurface_bleed].value.x() > albedo::largest_bleed)
        off(fmt::format("colours are exact for subsurface_bleed up to {}", albedo::largest_bleed));
    for (const Rounded &color : rounded_colors(material))
        off(fmt::format("a colour of {:.4g} takes an albedo nearer to 1 than a float tells, and shows as {:.4g}",
                        color.asked, color.shown));
    return found;
}

} // namespace nacre::scene
