// The medium of a diffusion model: what each lobe brings on a flat half-space, and a path that is about to take one.
#ifndef NACRE_DIFFUSION_MEDIUM_H
#define NACRE_DIFFUSION_MEDIUM_H

#include "diffusion/profile.h"
#include "geometry/surface.h"
#include "path/count.h"
#include "walk/medium.h"

// One channel: totals of the lobes on a flat half-space, which add up to the colour asked for.
typedef struct {
    float albedo; // single-scattering
    float single, multiple;
} Lobes;

// Colour of a half-space: van de Hulst's form (1980), to .03.
float color_van_de_hulst(float albedo, float g) {
    const float s = dipole_similarity(albedo, g);
    return (1.0f - s) * (1.0f - 0.139f * s) / (1.0f + 1.17f * s);
}

// `value` is the colour, or where `direct` the albedo: a sum of lobes above 1 is cut then, at the multiple one.
// `walk_albedo`: of a random walk, which sets burley's reduced length.
Lobes lobes_of(int model, float value, bool direct, float walk_albedo, float g) {
    Lobes lobes;
    if (model == MODEL_BURLEY) {
        lobes.albedo = walk_albedo;
        lobes.single = 0.0f;
        lobes.multiple = direct ? color_van_de_hulst(value, g) : value;
        return lobes;
    }
    const float s = direct ? dipole_similarity(value, g) : dipole_inverse(model, value, g);
    lobes.albedo = direct ? value : dipole_albedo(s, g);
    lobes.single = lobes.albedo * single_scattering(g);
    lobes.multiple = min(dipole_total(model, s), 1.0f - lobes.single);
    return lobes;
}

// Takes the path below `surface`. Kept until it leaves: albedo, the multiple lobe in `share`, the inward normal in `direction`.
void diffusion_enter(const Scene *scene, PATH_SPACE Path *path, global const Material *material, const Surface *surface,
                     Counts *counts) {
    medium_at(scene, material, surface->uv, path);
    const float3 value = clamp(material_color(scene, material, PARAMETER_subsurface_color, surface->uv), 0.0f, 1.0f);
    const bool direct = material->albedo_source == ALBEDO_GIVEN;
    const float3 g = path->anisotropy.xyz;
    const Lobes r = lobes_of(material->model, value.x, direct, path->albedo.x, g.x);
    const Lobes y = lobes_of(material->model, value.y, direct, path->albedo.y, g.y);
    const Lobes b = lobes_of(material->model, value.z, direct, path->albedo.z, g.z);
    path->albedo.xyz = (float3)(r.albedo, y.albedo, b.albedo);
    path->share.xyz = (float3)(r.multiple, y.multiple, b.multiple);
    path->weight.xyz = (float3)(r.single, y.single, b.single);
    path->direction.xyz = -surface->geometric;
    path->position.xyz = surface->position;
    path->object = surface->object;
    path->steps = 0u;
    path->state = PATH_PROBE;
    counts->value[COUNTER_walks] += 1u;
}

#endif
