// Where the light on an object comes from, coarsely: direct light on points of its surface, before the first sample.
#ifndef NACRE_GUIDE_SIDES_H
#define NACRE_GUIDE_SIDES_H

#include "path/path.h"

#define SIDE_SAMPLES 8u
#define SIDE_SEED 0x51de5u // not the scene's: its parts, rendered with other seeds, are to be guided alike

float luminance(float3 rgb) { return dot(rgb, (float3)(0.2126f, 0.7152f, 0.0722f)); }

// Radiance from where a ray goes that a surface sent out with density `density`; nothing from what it lights.
float3 side_light_met(const Scene *scene, Ray ray, float3 normal, float density) {
    PROFILED(uint visits[2]; visits[0] = visits[1] = 0u;) // nobody's rays
    const Hit hit = trace_closest(ray, scene->nodes, scene->blocks, scene->frame->bvh_root AND_PROFILED(visits));
    const bool missed = hit.block == BVH_NO_PRIMITIVE;
    const Receiver receiver = receiver_at(ray.origin, normal);
    float3 light = light_of_rects(scene, &receiver, ray.direction, missed ? MAXFLOAT : hit.t, density, false);
    if (missed) return light + light_of_sky(scene, &receiver, ray.direction, density, false);
    if (HAS(EMISSION)) {
        const Surface surface = surface_at(scene, ray, hit);
        light += light_of_surface(scene, &receiver, surface.primitive, surface.object, surface.uv, hit.t,
                                  -dot(ray.direction, surface.geometric), density);
    }
    return light;
}

// Luminance of the direct light on point i, irradiance over pi.
float side_light(const Scene *scene, uint i, float3 position, float3 normal) {
    const float3 error = (float3)(GUIDE_PROBE_START);
    PROFILED(uint visits[2]; visits[0] = visits[1] = 0u;)
    float sum = 0.0f;
    for (uint sample = 0; sample < SIDE_SAMPLES; sample++) {
        const Sampler sampler = sampler_of(SIDE_SEED, i, sample, 0u);
        const Shadow shadow = light_lambert(scene, (float3)(1.0f), sampler, position, error, normal, normal);
        if (shadow_asked(scene, &shadow) &&
            !trace_any(shadow.ray, scene->nodes, scene->blocks, scene->frame->bvh_root AND_PROFILED(visits)))
            sum += luminance(shadow.light);
        const float3 direction = lambert_sample(draw_pair(sampler, DRAW_DIRECTION), normal, normal);
        const Ray ray = path_ray(offset_point(position, error, normal, direction), direction);
        sum += luminance(side_light_met(scene, ray, normal, lambert_pdf(direction, normal, normal)));
    }
    return sum / SIDE_SAMPLES;
}

#endif
