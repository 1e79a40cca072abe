#include "io/gltf_draft.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace nacre::io {

namespace {

// How much goes under the surface: glTF's two ways to let light in, specular and diffuse, are one for nacre.
void translate_weight(GltfDraft &draft) {
    const Json &transmission = draft.extension("KHR_materials_transmission");
    const Json &diffuse = draft.extension("KHR_materials_diffuse_transmission");
    const double specular_weight = gltf_number(transmission, "transmissionFactor", 0, draft.where);
    const double diffuse_weight = gltf_number(diffuse, "diffuseTransmissionFactor", 0, draft.where);
    const double weight = std::max(specular_weight, diffuse_weight);
    draft.fields["subsurface_weight"] = weight;
    draft.add_texture(transmission, "transmissionTexture", shared::PARAMETER_subsurface_weight, ColorSpace::linear, 0,
                      Vec3::Constant(weight));
    if (weight == 0) draft.warn("scatters, but transmits nothing: without transmissionFactor light does not get in");
}

// KHR_materials_volume: sigma_t = -ln(attenuationColor) / attenuationDistance, in which the scatter extensions include
// scattering. nacre wants its reciprocal, the mean free path, as a radius and a scale per channel.
void translate_extinction(GltfDraft &draft, double fallback_radius) {
    const Json &volume = draft.extension("KHR_materials_volume");
    const Vec3 color = gltf_color(volume, "attenuationColor", Vec3::Ones(), draft.where);
    const double distance = gltf_number(volume, "attenuationDistance", 0, draft.where); // absent: infinite
    Vec3 extinction = Vec3::Zero();
    if (distance > 0)
        for (int c = 0; c < 3; ++c) // black would be infinitely dense; 1e-6 is opaque after a few attenuationDistances
            extinction[c] = -std::log(std::clamp(color[c], 1e-6, 1.0)) / distance;
    if (extinction == Vec3(0, 0, 0)) {
        draft.fields["subsurface_radius"] = fallback_radius;
        draft.fields["subsurface_radius_scale"] = 1;
        draft.warn(fmt::format("KHR_materials_volume gives no attenuation, so nothing could scatter; a mean free path "
                               "of {:.3g} is used (extras.nacre: {{\"subsurface_radius\": …}} sets another)",
                               fallback_radius));
        return;
    }
    // A channel that is not attenuated has an infinite path; ten thousand times the shortest is as transparent.
    const Vec3 path = extinction.cwiseMax(extinction.maxCoeff() * 1e-4).cwiseInverse();
    const Vec3 scale = path / path.maxCoeff();
    draft.fields["subsurface_radius"] = path.maxCoeff();
    draft.fields["subsurface_radius_scale"] = {scale.x(), scale.y(), scale.z()};
}

} // namespace

// Both drafts of the extension call the multi-scatter albedo of Kulla and Conty (2017) the colour, and invert it with
// van de Hulst's formula (KHR_materials_scatter with the anisotropy in it): nacre's inversion van_de_hulst.
// KHR_materials_scatter also has a strength, which multiplies the colour.
void translate_scatter(GltfDraft &draft, double fallback_radius) {
    const Json &older = draft.extension("KHR_materials_volume_scatter");
    const Json &newer = draft.extension("KHR_materials_scatter");
    if (older.empty() && newer.empty()) {
        if (!draft.extension("KHR_materials_transmission").empty() ||
            !draft.extension("KHR_materials_diffuse_transmission").empty())
            draft.warn("transmission without scattering is not drawn, the material is opaque");
        return;
    }
    const bool is_newer = !newer.empty();
    const Json &scatter = is_newer ? newer : older;
    const double strength = is_newer ? gltf_number(newer, "scatterStrengthFactor", 0, draft.where) : 1;
    const Vec3 unset = is_newer ? Vec3::Ones() : Vec3::Zero(); // each draft has its own default
    const char *name = scatter.contains("multiscatterColorFactor") ? "multiscatterColorFactor" : "multiscatterColor";
    const Vec3 color = strength * gltf_color(scatter, name, unset, draft.where);
    draft.fields["subsurface_color"] = {color.x(), color.y(), color.z()};
    draft.fields["subsurface_inversion"] = "van_de_hulst";
    draft.fields["subsurface_scatter_anisotropy"] = gltf_number(scatter, "scatterAnisotropy", 0, draft.where);
    draft.add_texture(scatter, "multiscatterColorTexture", shared::PARAMETER_subsurface_color, ColorSpace::srgb, -1,
                      color);
    if (scatter.contains("scatterStrengthTexture")) draft.warn("scatterStrengthTexture is not used");
    if (gltf_number(draft.extension("KHR_materials_volume"), "thicknessFactor", 0, draft.where) == 0)
        draft.warn("is thin-walled (no thicknessFactor); nacre draws it as a solid volume");
    translate_weight(draft);
    translate_extinction(draft, fallback_radius);
}

} // namespace nacre::io
