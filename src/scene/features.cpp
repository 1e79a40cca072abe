#include "scene/features.h"
#include "shared/features.h"
#include <algorithm>

namespace nacre::scene {
namespace {

using namespace shared;

/// A parameter is somewhere other than `nothing`; a texture may hold anything.
bool used(const Material &material, Parameter parameter, double nothing) {
    const Value &value = material[parameter];
    return value.texture >= 0 || (value.value.array() != nothing).any();
}

std::uint32_t material_features(const Material &material) {
    std::uint32_t mask = 0;
    const bool subsurface = used(material, PARAMETER_subsurface_weight, 0);
    const bool metal = used(material, PARAMETER_base_metalness, 0);
    if (subsurface) {
        mask |= FEATURE_SUBSURFACE;
        if (material.model != MODEL_RANDOM_WALK)
            mask |= FEATURE_DIFFUSION_MODEL;
        else if (used(material, PARAMETER_subsurface_bleed, 0))
            mask |= FEATURE_BLEED;
        if (used(material, PARAMETER_subsurface_scatter_anisotropy, 0)) mask |= FEATURE_ANISOTROPY;
        const Vec3 &g = material[PARAMETER_subsurface_scatter_anisotropy].value;
        if ((g.array() != g.x()).any()) mask |= FEATURE_ANISOTROPY_RGB;
        if (material.entry == ENTRY_REFRACTED || material.internal_reflection) mask |= FEATURE_INTERFACE;
    }
    if (used(material, PARAMETER_subsurface_weight, 1)) mask |= FEATURE_DIFFUSE;
    if (metal || used(material, PARAMETER_specular_weight, 0)) mask |= FEATURE_SPECULAR;
    if (used(material, PARAMETER_emission_luminance, 0) && used(material, PARAMETER_emission_color, 0))
        mask |= FEATURE_EMISSION;
    if (std::any_of(material.values.begin(), material.values.end(), [](const Value &v) { return v.texture >= 0; }))
        mask |= FEATURE_TEXTURES;
    if (subsurface && inverts_texture(material)) mask |= FEATURE_ALBEDO_TABLE;
    if (material[PARAMETER_geometry_normal].texture >= 0) mask |= FEATURE_NORMAL_MAP;
    return mask;
}

std::uint32_t light_feature(LightKind kind) {
    switch (kind) {
    case LIGHT_ENVIRONMENT: return FEATURE_ENVIRONMENT;
    case LIGHT_ENVIRONMENT_IMAGE: return FEATURE_ENVIRONMENT_IMAGE;
    case LIGHT_RECT: return FEATURE_RECT;
    case LIGHT_POINT:
    case LIGHT_DIRECTIONAL: return FEATURE_DELTA_LIGHT;
    case LIGHT_TRIANGLE: return FEATURE_EMISSION;
    }
    return 0;
}

std::uint32_t guide_feature(Guiding guiding) {
    switch (guiding) {
    case GUIDING_NONE: return 0;
    case GUIDING_DWIVEDI: return FEATURE_GUIDE_DWIVEDI;
    case GUIDING_EIGEN: return FEATURE_GUIDE_EIGEN;
    }
    return 0;
}

} // namespace

std::uint32_t features(const Scene &scene, bool surface_layers, bool scatter_layers) {
    std::uint32_t mask = (surface_layers ? FEATURE_SURFACE_AOV : 0) | (scatter_layers ? FEATURE_SCATTER_AOV : 0);
    for (const Object &object : scene.objects) {
        const Material &material = scene.materials[object.material];
        mask |= material_features(material);
        if (walks_below(material)) mask |= guide_feature(scene.render.guiding);
        if (!object.mesh.normals.empty()) mask |= FEATURE_SMOOTH;
    }
    for (const Light &light : scene.lights) mask |= light_feature(light.kind);
    if (scene.camera.kind == CAMERA_PERSPECTIVE && scene.camera.aperture > 0) mask |= FEATURE_LENS;
    return mask;
}

std::vector<std::string> feature_names(std::uint32_t mask) {
    static constexpr const char *all[] = {
#define FEATURE_NAME(name) #name,
        FEATURE_LIST(FEATURE_NAME)
#undef FEATURE_NAME
    };
    std::vector<std::string> names;
    for (int i = 0; i < FEATURE_COUNT; ++i) {
        if (!(mask & (1u << i))) continue;
        std::string name = all[i];
        std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return char(std::tolower(c)); });
        names.push_back(name);
    }
    return names;
}

} // namespace nacre::scene
