// Direct light on a path's vertex: one light is drawn, one shadow ray asks whether it is seen.
#ifndef NACRE_PATH_LIGHT_H
#define NACRE_PATH_LIGHT_H

#include "bsdf/lambert.h"
#include "bsdf/specular.h"
#include "geometry/surface.h"
#include "light/light.h"
#include "path/count.h"

bool light_seen(const Scene *scene, float3 position, float3 error, float3 geometric, const LightSample *sample,
                Counts *counts) {
    Ray ray;
    ray.origin = offset_point(position, error, geometric, sample->direction);
    ray.direction = sample->direction;
    ray.t_min = 0.0f;
    ray.t_max = MAXFLOAT;
    if (sample->distance < MAXFLOAT) { // from where the ray starts, not from where the surface is
        const float3 to = sample->target - ray.origin;
        ray.t_max = length(to);
        ray.direction = to * (1.0f / ray.t_max);
    }
    counts->value[COUNTER_shadow_rays] += 1u;
    return !trace_any(ray, scene->nodes, scene->blocks, scene->frame->bvh_root);
}

bool scene_samples_lights(const Scene *scene) {
    return (HAS(ENVIRONMENT_IMAGE) || HAS(RECT) || HAS(EMISSION) || HAS(DELTA_LIGHT)) && scene->frame->light_count > 0u;
}

// Weight of a drawn light against the BSDF, which finds its direction with `pdf`.
float light_share(const LightSample *sample, float pdf) {
    return sample->density > 0.0f ? light_weight(sample->density, pdf) : 1.0f;
}

float largest3(float3 v) { return fmax(v.x, fmax(v.y, v.z)); }

// Direct light on a Lambertian vertex (albedo in the throughput).
void light_lambert(const Scene *scene, Path *path, Sampler sampler, float3 position, float3 error, float3 shading,
                   float3 geometric, Counts *counts) {
    LightSample sample;
    if (!scene_samples_lights(scene) || !light_sample(scene, sampler, position, &sample)) return;
    const float pdf = lambert_pdf(sample.direction, shading, geometric);
    if (!(pdf > 0.0f) || !light_seen(scene, position, error, geometric, &sample, counts)) return;
    path->radiance.xyz += path->throughput.xyz * sample.radiance * (pdf * light_share(&sample, pdf));
}

#endif
