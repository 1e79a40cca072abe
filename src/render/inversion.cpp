#include "render/inversion.h"
#include "albedo/inversion.h"
#include "base/parallel.h"
#include "render/convert.h"
#include "shared/inversion.h"
#include <cmath>

namespace nacre::render {
namespace {

using namespace shared;

/// The medium below a material for one g and bleed. Diffusion models know neither flights nor ways to enter.
albedo::Medium medium_of(const scene::Material &material, double g, double bleed) {
    if (material.model != MODEL_RANDOM_WALK) return {.anisotropy = g};
    return {.anisotropy = g, .bleed = bleed, .flight = material.flight, .entry = material.entry};
}

/// Similarities by colour for the k-th g and bleed of a table.
void fill_column(const scene::Material &material, const Material &table, std::size_t k, float *column) {
    const auto along = [&](std::size_t i, std::size_t count) { return double(i) / double(count - 1); };
    double g = material[PARAMETER_subsurface_scatter_anisotropy].value.x();
    double bleed = material[PARAMETER_subsurface_bleed].value.x();
    if (table.similarity_anisotropies > 1)
        g = std::lerp(double(INVERSION_LEAST_ANISOTROPY), double(INVERSION_LARGEST_ANISOTROPY),
                      along(k % table.similarity_anisotropies, INVERSION_ANISOTROPIES));
    if (table.similarity_bleeds > 1)
        bleed = INVERSION_LARGEST_BLEED * std::pow(along(k / table.similarity_anisotropies, INVERSION_BLEEDS), 2);
    for (std::size_t i = 0; i < INVERSION_COLORS; ++i) {
        const double found =
            albedo::albedo(material.inversion, along(i, INVERSION_COLORS), medium_of(material, g, bleed));
        column[i] = float(std::sqrt((1 - found) / (1 - g * found)));
    }
}

} // namespace

void add_albedos(const scene::Scene &scene, std::vector<Material> &materials, std::vector<float> &similarities) {
    for (std::size_t m = 0; m < materials.size(); ++m) {
        const scene::Material &source = scene.materials[m];
        Material &material = materials[m];
        const scene::Value &g = source[PARAMETER_subsurface_scatter_anisotropy];
        const scene::Value &bleed = source[PARAMETER_subsurface_bleed];
        material.albedo_source = ALBEDO_GIVEN;
        if (!scene::scatters_below(source) || source.inversion == INVERSION_NONE) continue;
        if (!scene::inverts_texture(source)) {
            Vec3 albedo = source[PARAMETER_subsurface_color].value;
            for (int c = 0; c < 3; ++c)
                albedo[c] = albedo::albedo(source.inversion, albedo[c], medium_of(source, g.value[c], bleed.value.x()));
            material.albedo = to_float4(albedo);
            material.albedo_source = ALBEDO_FIXED;
            continue;
        }
        material.albedo_source = ALBEDO_TABLE;
        material.similarity_first = uint(similarities.size());
        const bool three = (g.value.array() != g.value.x()).any();
        material.similarity_anisotropies = g.texture >= 0 || three ? INVERSION_ANISOTROPIES : 1;
        material.similarity_bleeds = bleed.texture >= 0 && source.model == MODEL_RANDOM_WALK ? INVERSION_BLEEDS : 1;
        const std::size_t columns = std::size_t(material.similarity_anisotropies) * material.similarity_bleeds;
        similarities.resize(similarities.size() + columns * INVERSION_COLORS);
        float *first = similarities.data() + material.similarity_first;
        parallel_for(columns, [&](std::size_t k) { fill_column(source, material, k, first + k * INVERSION_COLORS); });
    }
}

} // namespace nacre::render
