// A path's guide, as it is kept with the path and as its lane needs it.
#ifndef NACRE_GUIDE_LOAD_H
#define NACRE_GUIDE_LOAD_H

#include "geometry/surface.h"
#include "guide/guide.h"

// The nearest of the material's modes for each channel, counted from its first: never one between two, whose phi and nu would
// not belong together.
uint4 nearest_modes(global const Material *material, float4 albedo, float4 g) {
    const float4 similarity2 = (1.0f - albedo) / max(1.0f - albedo * g, 1e-6f);
    uint4 i = convert_uint4_rte(sqrt(sqrt(clamp(similarity2, 0.0f, 1.0f))) * (float)(GUIDE_ALBEDOS - 1));
    if (material->guide_anisotropies > 1u) {
        const float4 at = (clamp(g / GUIDE_LARGEST_ANISOTROPY, -1.0f, 1.0f) + 1.0f) * (float)GUIDE_ANISOTROPIES;
        i += convert_uint4_rte(at) * GUIDE_ALBEDOS;
    }
    return i;
}

void mode_load(const Scene *scene, ModeLanes *lanes, uint l, global const GuideMode *mode, float g) {
    if (HAS(ANISOTROPY)) {
        float phi[GUIDE_TERMS], scattered[GUIDE_TERMS], power = 1.0f;
#pragma unroll
        for (int k = 0; k < GUIDE_TERMS; k++) {
            phi[k] = mode->phi[k];
            scattered[k] = power * mode->phi[k];
            power *= g;
        }
        polynomial_load(&lanes->phi, l, phi);
        polynomial_load(&lanes->scattered, l, scattered);
        LANE_FLOAT(lanes->peak, l) = mode->peak;
    }
    LANE_FLOAT(lanes->inverse_nu, l) = mode->inverse_nu;
    LANE_FLOAT(lanes->spread, l) = mode->spread;
}

// Under bleed the modes are poor guides, whose steps' weights multiply.
float guide_share(float share, float bleed) { return share / (1.0f + 0.2f * bleed); }

// The plane of the entry, which a guide and a twin ask for.
void plane_load(GuideLanes *guide, uint l, const PATH_SPACE Path *path) {
    LANE_FLOAT(guide->outward.x, l) = path->outward.x;
    LANE_FLOAT(guide->outward.y, l) = path->outward.y;
    LANE_FLOAT(guide->outward.z, l) = path->outward.z;
    LANE_FLOAT(guide->offset, l) = path->outward.w;
}

void guide_load(const Scene *scene, GuideLanes *guide, uint l, const PATH_SPACE Path *path) {
    global const Material *material = scene->materials + scene->objects[path->object].material;
    LANE_FLOAT(guide->thickness, l) = path->thickness;
    LANE_FLOAT(guide->share, l) = guide_share(scene->objects[path->object].guided, path->bleed);
    LANE_FLOAT(guide->far_light, l) = path->far_light;
    LANE_UINT(guide->tries, l) = path->tries;
    const float4 g = path->anisotropy;
    const uint4 i = nearest_modes(material, path->albedo, g);
    mode_load(scene, &guide->x, l, scene->modes + material->guide_first[0] + i.x, g.x);
    mode_load(scene, &guide->y, l, scene->modes + material->guide_first[1] + i.y, g.y);
    mode_load(scene, &guide->z, l, scene->modes + material->guide_first[2] + i.z, g.z);
}

// Light on the far side of a slab over that on the near side, which faces `outward`.
float guide_far_light(global const LightSides *sides, float3 outward) {
    const float3 share = outward * outward, upper = sides->upper.xyz, lower = sides->lower.xyz;
    const float near = dot(share, select(lower, upper, outward > 0.0f)),
                far = dot(share, select(upper, lower, outward > 0.0f));
    if (!(near + far > 0.0f)) return 1.0f;
    return clamp(far / near, GUIDE_LEAST_LIGHT, 1.0f / GUIDE_LEAST_LIGHT);
}

// The slab that a walk begins in, from below `surface`.
void guide_begin(const Scene *scene, PATH_SPACE Path *path, const Surface *surface) {
    path->thickness = scene->thickness[surface->primitive];
    path->tries = 0u;
    path->far_light = guide_far_light(scene->sides + path->object, surface->geometric);
}

#endif
