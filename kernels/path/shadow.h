// Direct light that is yet to be asked for: what a path's vertex gets from a light if nothing is in the way.
#ifndef NACRE_PATH_SHADOW_H
#define NACRE_PATH_SHADOW_H

#include "geometry/surface.h"
#include "light/light.h"

typedef struct {
    Ray ray;
    float3 light;    // to add to the path's radiance
    float3 foreseen; // to its control variate (path/control.h); both 0: nothing to ask
    bool across;     // that of a slab's other side
} Shadow;

Shadow no_shadow(void) {
    Shadow shadow;
    shadow.light = shadow.foreseen = (float3)(0.0f);
    shadow.across = false;
    return shadow;
}

float largest3(float3 v) { return max(v.x, max(v.y, v.z)); }

// NaN asks too: it has to show.
bool shadow_asked(const Scene *scene, const Shadow *shadow) {
    const float3 foreseen = shadow->foreseen;
    if (HAS(CONTROL) && foreseen.x + foreseen.y + foreseen.z != 0.0f) return true;
    return shadow->light.x + shadow->light.y + shadow->light.z != 0.0f;
}

// It arrives.
void shadow_light(const Scene *scene, PATH_SPACE Path *path, float3 light, float3 foreseen, bool across) {
    path->radiance.xyz += light;
    if (HAS(SLABS) && across)
        path->foreseen_across.xyz += foreseen;
    else if (HAS(CONTROL))
        path->foreseen.xyz += foreseen;
}

// `light` arrives at `position` along `sample` unless something is in the way.
Shadow shadow_of(float3 position, float3 error, float3 geometric, const LightSample *sample, float3 light) {
    Shadow shadow = no_shadow();
    shadow.light = light;
    shadow.ray.origin = offset_point(position, error, geometric, sample->direction);
    shadow.ray.direction = sample->direction;
    shadow.ray.t_min = 0.0f;
    shadow.ray.t_max = MAXFLOAT;
    if (sample->distance < MAXFLOAT) { // from where the ray starts, not from where the surface is
        const float3 to = sample->target - shadow.ray.origin;
        shadow.ray.t_max = length3(to);
        shadow.ray.direction = to * (1.0f / shadow.ray.t_max);
    }
    return shadow;
}

#endif
