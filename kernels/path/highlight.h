// Direct light where the reflecting layer mirrors a lamp. One point of one light, drawn by what it brings to the surface, says
// little about a highlight: the rim of a head before a lamp made 3/4 of the variance of its whole picture. There some are drawn,
// and one of them in proportion to what it shows, so that one shadow ray serves as before: resampled importance sampling
// (Talbot, Cline, Egbert 2005, "Importance Resampling for Global Illumination").
#ifndef NACRE_PATH_HIGHLIGHT_H
#define NACRE_PATH_HIGHLIGHT_H

#include "path/light.h"

// So many are drawn. With 8 the head (g 0) has 1.09 times the variance and takes .97 times as long, with 32 .85 and 1.07 times, of
// which pictures of less light in highlights have only the time. 1: no more than elsewhere.
#ifndef HIGHLIGHT_CANDIDATES
#define HIGHLIGHT_CANDIDATES 16u
#endif

// Layers that reflect less are not worth the time. Metals are not either: all their paths are reflected, and find lamps.
#define HIGHLIGHT_REFLECTANCE 0.05f

// How far about the mirrored view a lamp still shows, in alphas.
#define HIGHLIGHT_REACH 2.0f

// Whether the mirrored view, a unit vector, points to about where a flat light is.
bool is_mirrored(global const Light *light, float3 position, float3 mirrored, float reach) {
    const float middle = light->kind == LIGHT_TRIANGLE ? 1.0f / 3.0f : 0.5f;
    const float3 to = light->position.xyz + middle * (light->u.xyz + light->v.xyz) - position;
    const float distance = length3(to), radius = sqrt(INV_PI * light->normal.w);
    return length3(to - distance * mirrored) < reach * distance + radius;
}

// How many lights to draw for a surface that is seen from `view`.
uint highlight_candidates(const Scene *scene, const Specular *specular, float3 position, float3 view) {
    const bool few_lamps = (HAS(RECT) || HAS(EMISSION)) && scene->frame->light_count <= LIGHT_FEW;
    if (!few_lamps) return 1u;
    const float reflectance = (1.0f - specular->metalness) * fresnel_dielectric(specular->view.z, specular->eta);
    if (reflectance < HIGHLIGHT_REFLECTANCE) return 1u;
    const float3 mirrored = 2.0f * specular->view.z * specular->normal - view;
    for (uint i = 0; i < scene->frame->light_count; i++) {
        global const Light *light = scene->lights + i;
        const bool flat = light->kind == LIGHT_RECT || light->kind == LIGHT_TRIANGLE;
        if (flat && is_mirrored(light, position, mirrored, HIGHLIGHT_REACH * specular->alpha)) return HIGHLIGHT_CANDIDATES;
    }
    return 1u;
}

// What a draw shows of its light, about. Nothing only where neither the layer nor the base, which returns `below`, sees it.
float highlight_shown(const Surface *surface, const Specular *specular, float below, const LightSample *sample) {
    const float3 r = specular_eval(specular, sample->direction);
    const float base = below * lambert_pdf(sample->direction, surface->shading, surface->geometric);
    return largest3(sample->radiance) * (largest3(r) * light_share(sample, specular_density(r)) + base);
}

// As light_sample. Of `candidates` it takes one, as likely as it shows, which stands for them all: it is as dense as they, and as
// bright. `specular` matters to several.
bool highlight_sample(const Scene *scene, Sampler sampler, const Surface *surface, const Specular *specular, float below,
                      uint candidates, LightSample *sample) {
    const Receiver receiver = receiver_at(surface->position, surface->geometric);
    const float few = strength_of_few(scene, &receiver);
    float sum = 0.0f, taken = 1.0f, xi = candidates > 1u ? draw_pair(sampler, DRAW_LIGHT_POINT).x : 0.0f;
    for (uint k = 0; k < candidates; k++) {
        LightSample candidate;
        const Sampler own = sampler_with(sampler.key, sampler.sample * candidates + k, sampler.vertex);
        if (!light_sample(scene, own, &receiver, few, &candidate)) continue;
        candidate.density *= (float)candidates;
        const float shown = candidates > 1u ? highlight_shown(surface, specular, below, &candidate) : 1.0f;
        if (shown <= 0.0f) continue;
        sum += shown;
        const float chance = shown / sum; // that it takes the place of those before
        if (!(xi >= chance)) { // NaN is taken: it has to show
            *sample = candidate;
            taken = shown;
            xi /= chance;
        } else {
            xi = (xi - chance) / (1.0f - chance);
        }
    }
    if (sum == 0.0f) return false;
    sample->radiance *= sum / (taken * (float)candidates);
    return true;
}

#endif
