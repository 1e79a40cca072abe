#include "render/control.h"
#include "render/body.h"
#include "shared/guide.h"
#include "shared/inversion.h"
#include <cmath>

namespace nacre::render {
namespace {

using namespace shared;

/// From which thickness on, in the scene's units, a control variate pays. It takes away the noise of the channels'
/// weights. A grey medium has next to none, guided walks return about the same weight each, and there twins that part
/// from their walks bring more noise than they take. In the largest of the medium's diffusion lengths variance times
/// time of balls under a lamp and some sky is as good with as without, g 0 and .8, at .25 where the least is a
/// twentieth or a tenth of it (skin, milk), .5 at .3 (marble), 1.1 at .44, 1.5 to 2 at .6, and 6 to 12 where all are
/// alike. This is a fit to those. Under bleed twins go far: balls of skin of .33 lengths are .56 times as good at bleed
/// .5, of 3.3 lengths .67 times at bleed 1 and 1.9 times at .5 (build/bench/guiding --filter sphere). Under an image of
/// the sky (scenes/features/environment_image.json) it is .9 times as good all the same.
double least_thickness(const Vec3 &lengths, double bleed) {
    const double largest = lengths.maxCoeff();
    if (!(largest > 0)) return 0;
    return .25 * std::pow(30., lengths.minCoeff() / largest) * std::pow(16., bleed) * largest;
}

/// Colours are known to 1e-4 within the table of inversions (build/bench/inversion).
bool in_table(const scene::Material &material) {
    const scene::Value &g = material[PARAMETER_subsurface_scatter_anisotropy],
                       &bleed = material[PARAMETER_subsurface_bleed];
    return g.texture < 0 && g.value.minCoeff() >= double(INVERSION_LEAST_ANISOTROPY) &&
           g.value.maxCoeff() <= double(INVERSION_LARGEST_ANISOTROPY) && bleed.texture < 0 &&
           bleed.value.x() <= double(INVERSION_LARGEST_BLEED);
}

bool knows_color(const scene::Material &material) {
    return scene::walks_below(material) && material.inversion == INVERSION_TABLE && material.entry == ENTRY_LAMBERT &&
           !material.internal_reflection && material.max_depth == 0 && in_table(material);
}

} // namespace

bool choose_control(const scene::Scene &scene, const scene::Frame &frame, std::uint32_t features, Geometry &geometry) {
    bool some = false;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const scene::Object &object = scene.objects[i];
        const scene::Material &material = scene.materials[object.material];
        geometry.objects[i].control_thickness = GUIDE_THICK;
        if (!scene.render.control || (features & FEATURE_SCATTER_AOV) || !knows_color(material)) continue;
        const double least =
            least_thickness(diffusion_length(scene, material), material[PARAMETER_subsurface_bleed].value.x());
        if (!(thickness(object.mesh) >= least)) continue; // nor in white, where it is infinite or NaN
        geometry.objects[i].control_thickness = float(least / frame.size);
        some = true;
    }
    return some;
}

} // namespace nacre::render
