#include "scene/scene.h"

namespace nacre::scene {

// OpenPBR 1.1's defaults, plus ours for what it lacks (bleed 0: exponential flights).
Material::Material() {
    const auto set = [this](shared::Parameter p, const Vec3 &value) { values[p].value = value; };
    const auto number = [&set](shared::Parameter p, double value) { set(p, Vec3::Constant(value)); };
    number(shared::PARAMETER_base_color, 0.8);
    number(shared::PARAMETER_base_metalness, 0);
    number(shared::PARAMETER_specular_weight, 1);
    number(shared::PARAMETER_specular_roughness, 0.3);
    number(shared::PARAMETER_specular_ior, 1.5);
    number(shared::PARAMETER_emission_luminance, 0);
    number(shared::PARAMETER_emission_color, 1);
    number(shared::PARAMETER_subsurface_weight, 0);
    number(shared::PARAMETER_subsurface_color, 0.8);
    number(shared::PARAMETER_subsurface_radius, 1);
    set(shared::PARAMETER_subsurface_radius_scale, Vec3(1, 0.5, 0.25));
    number(shared::PARAMETER_subsurface_scatter_anisotropy, 0);
    number(shared::PARAMETER_subsurface_bleed, 0);
    set(shared::PARAMETER_geometry_normal, Vec3(0, 0, 1)); // in tangent space: unperturbed
}

bool scatters_below(const Material &material) {
    const Value &weight = material[shared::PARAMETER_subsurface_weight];
    return weight.texture >= 0 || weight.value.x() > 0;
}

bool walks_below(const Material &material) {
    return scatters_below(material) && material.model == shared::MODEL_RANDOM_WALK;
}

bool inverts_texture(const Material &material) {
    const auto painted = [&](shared::Parameter p) { return material[p].texture >= 0; };
    const bool walks = material.model == shared::MODEL_RANDOM_WALK;
    if (material.inversion == shared::INVERSION_NONE || !(walks || material.model == shared::MODEL_BURLEY))
        return false; // dipoles have inversions of their own
    return painted(shared::PARAMETER_subsurface_color) || painted(shared::PARAMETER_subsurface_scatter_anisotropy) ||
           (walks && painted(shared::PARAMETER_subsurface_bleed));
}

} // namespace nacre::scene
