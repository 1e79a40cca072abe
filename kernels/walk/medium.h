// The medium below a point of a surface, and the step through it: what the material asks for, as extinction and albedo.
#ifndef NACRE_WALK_MEDIUM_H
#define NACRE_WALK_MEDIUM_H

#include "bsdf/material.h"
#include "shared/inversion.h"

// Where a value lies on an axis of a table: the node below it, and how far to the next.
typedef struct {
    uint node;
    float share;
} TablePlace;

TablePlace table_place(float at, uint nodes) {
    TablePlace place;
    const float clamped = clamp(at, 0.0f, (float)(nodes - 1u));
    place.node = min((uint)clamped, nodes - 2u);
    place.share = clamped - (float)place.node;
    return place;
}

// Similarity of a medium that shows `color` (clamped to [0, 1]), from its material's table.
float similarity_at(const Scene *scene, global const Material *material, float color, float g, float bleed) {
    const TablePlace x = table_place(color * (float)(INVERSION_COLORS - 1), INVERSION_COLORS);
    TablePlace y = {0u, 0.0f}, z = {0u, 0.0f};
    if (material->similarity_anisotropies > 1u) {
        const float range = INVERSION_LARGEST_ANISOTROPY - INVERSION_LEAST_ANISOTROPY;
        const float at = (g - INVERSION_LEAST_ANISOTROPY) / range * (float)(INVERSION_ANISOTROPIES - 1);
        y = table_place(at, INVERSION_ANISOTROPIES);
    }
    if (material->similarity_bleeds > 1u)
        z = table_place(sqrt(max(0.0f, bleed) / INVERSION_LARGEST_BLEED) * (float)(INVERSION_BLEEDS - 1), INVERSION_BLEEDS);
    const uint row = INVERSION_COLORS, layer = row * material->similarity_anisotropies;
    global const float *first = scene->similarities + material->similarity_first + z.node * layer + y.node * row + x.node;
    const uint next_row = material->similarity_anisotropies > 1u ? row : 0u;
    const uint next_layer = material->similarity_bleeds > 1u ? layer : 0u;
    const float low = mix(mix(first[0], first[1], x.share), mix(first[next_row], first[next_row + 1u], x.share), y.share);
    first += next_layer;
    const float high = mix(mix(first[0], first[1], x.share), mix(first[next_row], first[next_row + 1u], x.share), y.share);
    return mix(low, high, z.share);
}

// Single-scattering albedo of a medium with this similarity (van de Hulst 1980).
float albedo_of_similarity(float s, float g) { return (1.0f - s * s) / (1.0f - g * s * s); }

float3 medium_albedo(const Scene *scene, global const Material *material, float3 color, float3 g, float bleed) {
    if (HAS(ALBEDO_TABLE) && material->albedo_source == ALBEDO_TABLE)
        return (float3)(albedo_of_similarity(similarity_at(scene, material, color.x, g.x, bleed), g.x),
                        albedo_of_similarity(similarity_at(scene, material, color.y, g.y, bleed), g.y),
                        albedo_of_similarity(similarity_at(scene, material, color.z, g.z, bleed), g.z));
    return material->albedo_source == ALBEDO_FIXED ? material->albedo.xyz : clamp(color, 0.0f, 1.0f);
}

// Fills the medium of a path that enters at `uv`, and returns the colour that it shows, in [0, 1]. Textures are read here, once per walk.
float3 medium_at(const Scene *scene, global const Material *material, float2 uv, PATH_SPACE Path *path) {
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
    path->sigma.xyz = 1.0f / max((float3)(1e-7f), free_path);
    const float3 color = material_color(scene, material, PARAMETER_subsurface_color, uv);
    path->albedo.xyz = medium_albedo(scene, material, color, path->anisotropy.xyz, path->bleed);
    path->flight = (uint)material->flight;
    path->max_depth = material->max_depth;
    return clamp(color, 0.0f, 1.0f);
}

#endif
