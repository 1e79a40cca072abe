// The control variate of a path's first walk, seen from the path: the light about the entry, and what the twin brings back.
#ifndef NACRE_PATH_CONTROL_H
#define NACRE_PATH_CONTROL_H

#include "guide/load.h"
#include "path/light.h"
#include "walk/returned.h"
#include "walk/twin.h"

bool twin_in_slab(const Scene *scene, uint twin) { return HAS(SLABS) && twin >= TWIN_SLAB; }

global const Slab *control_slab(const Scene *scene, uint twin) { return scene->slabs + (twin - TWIN_SLAB); }

// What a slab lets through of the far side's light over what it returns of the near side's.
float control_through(const Scene *scene, const Surface *surface, uint twin) {
    return control_slab(scene, twin)->through * guide_far_light(scene->sides + surface->object, surface->geometric);
}

// Whether it matters what a twin brings through the far side, and through that of the entry.
bool control_sees_far(const Scene *scene, const Surface *surface, uint twin) {
    return twin_in_slab(scene, twin) && control_through(scene, surface, twin) * CONTROL_MOST_LIGHT >= 1.0f;
}

bool control_sees_near(const Scene *scene, const Surface *surface, uint twin) {
    return twin_in_slab(scene, twin) ? control_through(scene, surface, twin) < CONTROL_MOST_LIGHT : twin == TWIN_INSIDE;
}

// The thinnest slab of its object that is as thick as it is at `surface`, or TWIN_NONE.
uint control_slab_at(const Scene *scene, const Surface *surface, float thickness) {
    global const LightSides *sides = scene->sides + surface->object;
    for (uint i = sides->first_slab; i < sides->first_slab + sides->slab_count; i++)
        if (scene->slabs[i].thickness >= thickness) return TWIN_SLAB + i;
    return TWIN_NONE;
}

// Which twin a walk that begins at `surface` is to have: in a slab where light gets through, else in a half-space, or in a slab
// that is too thin for one, unless it is lit from behind. Later walks of a path make less of a pixel's noise.
uint control_twin(const Scene *scene, const PATH_SPACE Path *path, const Surface *surface) {
    if (path->hits > 1u) return TWIN_NONE;
    global const LightSides *sides = scene->sides + surface->object;
    const float thickness = scene->thickness[surface->primitive];
    const uint in_slab = HAS(SLABS) ? control_slab_at(scene, surface, thickness) : TWIN_NONE;
    if (control_sees_far(scene, surface, in_slab)) return in_slab;
    if (sides->lit_in_sight == 0u || guide_far_light(sides, surface->geometric) > CONTROL_MOST_LIGHT) return TWIN_NONE;
    return thickness > scene->objects[surface->object].control_thickness ? TWIN_INSIDE : in_slab;
}

// The walk's twin begins. `shown`: what a half-space returns; `color`: the walk's first weights.
void control_begin(const Scene *scene, PATH_SPACE Path *path, uint twin, float3 color, float3 shown) {
    path->twin = twin;
    if (twin == TWIN_INSIDE) path->surplus.xyz = color * shown;
    if (!twin_in_slab(scene, twin)) return;
    path->surplus.xyz = color * slab_shows(scene, path, control_slab(scene, twin), false);
    path->surplus_across.xyz = color * slab_shows(scene, path, control_slab(scene, twin), true);
}

// Numbers for the light about both points: those of the entry, which a path that enters does not need for anything else.
Sampler control_sampler(const PATH_SPACE Path *path) { return sampler_with(path->key, path->sample, path->vertex - 1u); }

// What light_lambert will find at the exit, foreseen at the entry.
float3 control_light(const PATH_SPACE Path *path, const Surface *surface, const LightSample *sample) {
    const float pdf = lambert_pdf(sample->direction, surface->shading, surface->geometric);
    if (!(pdf > 0.0f)) return (float3)(0.0f);
    return path->throughput.xyz * sample->radiance * (pdf * light_share(sample, pdf));
}

// What the ray will find that leaves the exit.
Shadow control_bounce(const Scene *scene, const PATH_SPACE Path *path, const Surface *exit) {
    const float3 direction = lambert_sample(draw_pair(control_sampler(path), DRAW_DIRECTION), exit->shading, exit->geometric);
    const float pdf = lambert_pdf(direction, exit->shading, exit->geometric);
    Shadow shadow = no_shadow();
    shadow.ray = path_ray(offset_point(exit->position, exit->error, exit->geometric, direction), direction);
    const Receiver receiver = receiver_at(shadow.ray.origin, exit->geometric);
    shadow.foreseen = path->throughput.xyz * (light_of_rects(scene, &receiver, direction, MAXFLOAT, pdf, false) +
                                              light_of_sky(scene, &receiver, direction, pdf, false));
    return shadow;
}

// Light that is foreseen beside control_light: bounces on either side, and the lights' on the far one. Returns how much of it.
#define CONTROL_SHADOWS 3u

uint control_foresee(const Scene *scene, const PATH_SPACE Path *path, const Surface *surface, Shadow *shadows) {
    uint count = 0u;
    if (control_sees_near(scene, surface, path->twin)) shadows[count++] = control_bounce(scene, path, surface);
    if (!control_sees_far(scene, surface, path->twin)) return count;
    // A little beyond the far side, so that what the walk leaves behind casts no shadow on it.
    Surface exit = *surface;
    exit.position -= (1.001f * control_slab(scene, path->twin)->thickness) * surface->geometric;
    exit.shading = exit.geometric = -surface->geometric;
    Shadow light = light_lambert(scene, path->throughput.xyz, control_sampler(path), exit.position, exit.error, exit.shading,
                                 exit.geometric);
    light.foreseen = light.light;
    light.light = (float3)(0.0f);
    shadows[count] = control_bounce(scene, path, &exit);
    shadows[count + 1u] = light;
    shadows[count].across = shadows[count + 1u].across = true;
    return count + 2u;
}

void twin_load(const Scene *scene, TwinLanes *twin, uint l, const PATH_SPACE Path *path) {
    const float3 foreseen = HAS(SLABS) ? path->foreseen.xyz + path->foreseen_across.xyz : path->foreseen.xyz;
    if (HAS(SLABS))
        LANE_FLOAT(twin->thickness, l) =
            twin_in_slab(scene, path->twin) ? control_slab(scene, path->twin)->thickness : GUIDE_THICK;
    const bool counts = path->twin >= TWIN_INSIDE && foreseen.x + foreseen.y + foreseen.z != 0.0f; // else in darkness
    LANE_INT(twin->inside, l) = counts ? MASK_TRUE : 0;
}

// The twin is out.
void control_take(const Scene *scene, PATH_SPACE Path *path, const TwinLanes *twin, uint l) {
    const float3 left = (float3)(LANE_FLOAT(twin->left.x, l), LANE_FLOAT(twin->left.y, l), LANE_FLOAT(twin->left.z, l));
    if (HAS(SLABS) && LANE_INT(twin->across, l) != 0)
        path->surplus_across.xyz -= left;
    else
        path->surplus.xyz -= left;
    path->twin = TWIN_OUT;
}

// The walk of lane l is out, or lost, and its twin is not.
void control_part(const Scene *scene, PATH_SPACE Path *path, const TwinLanes *twin, uint l) {
    const float3 position =
        (float3)(LANE_FLOAT(twin->position.x, l), LANE_FLOAT(twin->position.y, l), LANE_FLOAT(twin->position.z, l));
    const float3 weight = (float3)(LANE_FLOAT(twin->weight.x, l), LANE_FLOAT(twin->weight.y, l), LANE_FLOAT(twin->weight.z, l));
    const float depth = path->outward.w - dot(path->outward.xyz, position), rise = dot(path->outward.xyz, path->direction.xyz);
    if (!twin_in_slab(scene, path->twin)) {
        path->surplus.xyz -= weight * half_space_returns(scene, path, depth, rise);
    } else {
        global const Slab *slab = control_slab(scene, path->twin);
        path->surplus.xyz -= weight * slab_returns(scene, path, slab, depth, rise);
        path->surplus_across.xyz -= weight * slab_returns(scene, path, slab, slab->thickness - depth, -rise);
    }
    path->twin = TWIN_OUT;
}

#endif
