#include "render/control.h"
#include "render/body.h"
#include "shared/guide.h"
#include "shared/inversion.h"

namespace nacre::render {
namespace {

using namespace shared;

/// In diffusion lengths. In relative variance times time balls and the memo's head are 1.2 to 30 times as good from
/// there on (a ball of .56 lengths, mean free path a tenth of its size: 2.3 times); thinner, a ball of .19 is .93 times
/// and the bear, whose twins walk far, .5 times as good.
/// Under an image of the sky (scenes/features/environment_image.json) .9 times.
constexpr double least_thickness = .25;

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
        const double least = least_thickness * diffusion_length(scene, material).maxCoeff();
        if (thickness(object.mesh) < least) continue;
        geometry.objects[i].control_thickness = float(least / frame.size);
        some = true;
    }
    return some;
}

} // namespace nacre::render
