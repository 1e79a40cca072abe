// The medium below a point of a surface, and the step through it: what the material asks for, as extinction and albedo.
#ifndef NACRE_WALK_MEDIUM_H
#define NACRE_WALK_MEDIUM_H

#include "bsdf/material.h"

// Single-scattering albedo of a half-space that shows the colour x under white light. van de Hulst's form as in OpenPBR 1.1
// (section "Subsurface"): error up to .027 in colour (b = 0). x in [0, 1], g in (-1, 1).
float albedo_van_de_hulst(float x, float g) {
    const float root = sqrt(fmax(0.0f, 9.59217f + x * (41.6808f + 17.7126f * x)));
    const float s = clamp(4.09712f + 4.20863f * x - root, 0.0f, 1.0f);
    return (1.0f - s * s) / (1.0f - g * s * s);
}

float3 medium_albedo(global const Material *material, float3 color, float3 g) {
    const float3 x = clamp(color, 0.0f, 1.0f);
    if (material->inversion == INVERSION_NONE) return x;
    return (float3)(albedo_van_de_hulst(x.x, g.x), albedo_van_de_hulst(x.y, g.y), albedo_van_de_hulst(x.z, g.z));
}

// Fills the medium of a path that enters at `uv`. Textures are read here, once per walk.
void medium_at(const Scene *scene, global const Material *material, float2 uv, Path *path) {
    path->anisotropy.xyz = (float3)(0.0f);
    if (HAS(ANISOTROPY_RGB))
        path->anisotropy.xyz = material_color(scene, material, PARAMETER_subsurface_scatter_anisotropy, uv);
    else if (HAS(ANISOTROPY))
        path->anisotropy.xyz = material_number(scene, material, PARAMETER_subsurface_scatter_anisotropy, uv);
    path->bleed = HAS(BLEED) ? material_number(scene, material, PARAMETER_subsurface_bleed, uv) : 0.0f;
    const bool painted = HAS(TEXTURES) && material->texture[PARAMETER_subsurface_radius] >= 0;
    const float3 free_path = material_number(scene, material, PARAMETER_subsurface_radius, uv) *
                             (painted ? material->radius_scale : 1.0f) *
                             material_color(scene, material, PARAMETER_subsurface_radius_scale, uv);
    // A mean free path of 0 (a black texel) is a surface without depth: 1e-7 of the scene's size is as good as that.
    path->sigma.xyz = 1.0f / fmax(free_path, 1e-7f);
    path->albedo.xyz = medium_albedo(
        material, material_color(scene, material, PARAMETER_subsurface_color, uv), path->anisotropy.xyz);
    path->flight = (uint)material->flight;
    path->max_depth = material->max_depth;
}

#endif
