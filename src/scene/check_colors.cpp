#include "scene/check_colors.h"
#include "albedo/inversion.h"
#include "albedo/table.h"
#include <Imath/half.h>
#include <algorithm>
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

/// Colours below 1 whose albedo is 1 as a float.
std::vector<double> out_of_reach(const Material &material) {
    std::vector<double> found;
    const Value &color = material[PARAMETER_subsurface_color];
    for (int c = 0; c < 3 && color.texture < 0; ++c) {
        const albedo::Medium medium{.anisotropy = material[PARAMETER_subsurface_scatter_anisotropy].value[c],
                                    .bleed = material[PARAMETER_subsurface_bleed].value.x(),
                                    .flight = material.flight,
                                    .entry = material.entry};
        if (color.value[c] < 1 && float(albedo::albedo(material.inversion, color.value[c], medium)) == 1)
            found.push_back(color.value[c]);
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
    for (const double color : out_of_reach(material))
        off(fmt::format("a colour of {:.4g} takes an albedo that a float does not tell from 1", color));
    return found;
}

} // namespace nacre::scene
