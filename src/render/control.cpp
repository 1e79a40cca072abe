#include "render/control.h"
#include "render/body.h"
#include "shared/guide.h"
#include "shared/inversion.h"
#include <cmath>

namespace nacre::render {
namespace {

using namespace shared;

/// From which thickness on, in the scene's units, a control variate pays. It takes away the noise of the channels'
/// weights, of which grey media have next to none. In variance times time it is as good with as without, in the largest
/// of the medium's diffusion lengths: balls under a lamp and some sky at .08 where the least is a twentieth of it
/// (skin), .4 (g 0) and .1 (g .8) at .44 (wax), 1.5 where all are alike; there in light from everywhere it is .3 times
/// as good at .9, 1.1 times at 1.9 and 1.5 times at 3.4. At g 0 and bleed .5 balls of skin of .34 are 1.36 times as
/// good with, at g .8 those of .09 .75, at bleed 1 of .34 .7, of .9 1.14 and of 3.4 1.5 times. This is a fit to those.
/// Flat bodies have guides, which leave less noise: slabs of skin of .17 in light from everywhere are .55 times as good
/// with, of .85 3.5 times, grey ones of 4.7 12 times. In dark media, whose walks are over soon, it is the longer way to
/// the light that costs: at 3.3 balls of .02 are .78 times as good with, at 31 3.4 times.
double least_thickness(const Vec3 &lengths, double bleed, bool flat, bool dark) {
    const double largest = lengths.maxCoeff();
    if (!(largest > 0)) return 0;
    constexpr double grey = 3.2, colored = .025, colored_flat = .07;
    const double unlike = 1 - lengths.minCoeff() / largest;
    return (dark ? 2 : 1) * grey * std::pow(flat ? colored_flat : colored, unlike) * std::pow(8., bleed) * largest;
}

/// At bleed 1 so much light comes back from deeper than tables of what returns go (shared/returned.h) that pictures of
/// skin are .1 % bright in red; at .75 they are within .04 %.
constexpr double most_bleed = .75;

/// Colours are known to 1e-4 within the table of inversions (build/bench/inversion).
bool in_table(const scene::Material &material) {
    const scene::Value &g = material[PARAMETER_subsurface_scatter_anisotropy],
                       &bleed = material[PARAMETER_subsurface_bleed];
    return g.texture < 0 && g.value.minCoeff() >= double(INVERSION_LEAST_ANISOTROPY) &&
           g.value.maxCoeff() <= double(INVERSION_LARGEST_ANISOTROPY) && bleed.texture < 0 &&
           bleed.value.x() <= most_bleed;
}

bool knows_color(const scene::Material &material) {
    return scene::walks_below(material) && material.inversion == INVERSION_TABLE && material.entry == ENTRY_LAMBERT &&
           !material.internal_reflection && material.max_depth == 0 && in_table(material);
}

/// One medium everywhere, so that a few tables hold what slabs of it return.
bool is_uniform(const scene::Material &material) {
    return !scene::inverts_texture(material) && material[PARAMETER_subsurface_radius].texture < 0 &&
           material[PARAMETER_subsurface_radius_scale].texture < 0;
}

} // namespace

bool choose_control(const scene::Scene &scene, const scene::Frame &frame, std::uint32_t features, Geometry &geometry) {
    bool some = false;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const scene::Object &object = scene.objects[i];
        const scene::Material &material = scene.materials[object.material];
        geometry.objects[i].control_thickness = GUIDE_THICK;
        if (!scene.render.control || (features & FEATURE_SCATTER_AOV) || !knows_color(material)) continue;
        if (geometry.objects[i].closed && is_uniform(material) && is_plate(object.mesh))
            geometry.objects[i].plate = some = true;
        const double least =
            least_thickness(diffusion_length(scene, material), material[PARAMETER_subsurface_bleed].value.x(),
                            is_flat(scene, object), is_dark(scene, material));
        if (!(thickness(object.mesh) >= least)) continue; // nor in white, where it is infinite or NaN
        geometry.objects[i].control_thickness = float(least / frame.size);
        some = true;
    }
    return some;
}

} // namespace nacre::render
