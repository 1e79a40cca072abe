// The control variate of a path's first walk, seen from the path: the light about the entry, and what the twin brings back.
#ifndef NACRE_PATH_CONTROL_H
#define NACRE_PATH_CONTROL_H

#include "guide/load.h"
#include "path/light.h"
#include "walk/returned.h"
#include "walk/twin.h"

// Light on the far side over that on the near side, as guides have it, from which on a surface counts as lit from behind.
#define CONTROL_MOST_FAR_LIGHT 10.0f

// Whether a walk that begins at `surface` is to have a twin: only where light comes from that side. Later walks of a path make
// less of a pixel's noise.
bool control_pays(const Scene *scene, const PATH_SPACE Path *path, const Surface *surface) {
    global const Object *object = scene->objects + surface->object;
    if (path->hits > 1u || !(scene->thickness[surface->primitive] > object->control_thickness)) return false;
    return guide_far_light(scene->sides + surface->object, surface->geometric) < CONTROL_MOST_FAR_LIGHT;
}

// The walk's twin begins. `returned`: what a half-space returns, times the walk's first weights.
void control_begin(const Scene *scene, PATH_SPACE Path *path, const Surface *surface, float3 returned) {
    path->twin = control_pays(scene, path, surface) ? TWIN_INSIDE : TWIN_NONE;
    if (path->twin != TWIN_NONE) path->surplus.xyz = returned;
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
Shadow control_bounce(const Scene *scene, const PATH_SPACE Path *path, const Surface *surface) {
    const float3 direction =
        lambert_sample(draw_pair(control_sampler(path), DRAW_DIRECTION), surface->shading, surface->geometric);
    const float pdf = lambert_pdf(direction, surface->shading, surface->geometric);
    Shadow shadow = no_shadow();
    shadow.ray = path_ray(offset_point(surface->position, surface->error, surface->geometric, direction), direction);
    const Receiver receiver = receiver_at(shadow.ray.origin, surface->geometric);
    shadow.foreseen = path->throughput.xyz * (light_of_rects(scene, &receiver, direction, MAXFLOAT, pdf, false) +
                                              light_of_sky(scene, &receiver, direction, pdf, false));
    return shadow;
}

void twin_load(TwinLanes *twin, uint l, const PATH_SPACE Path *path) {
    const float3 foreseen = path->foreseen.xyz;
    const bool counts = path->twin == TWIN_INSIDE && foreseen.x + foreseen.y + foreseen.z != 0.0f; // else in darkness
    LANE_INT(twin->inside, l) = counts ? MASK_TRUE : 0;
}

// The twin is out.
void control_take(PATH_SPACE Path *path, const TwinLanes *twin, uint l) {
    path->surplus.xyz -= (float3)(LANE_FLOAT(twin->left.x, l), LANE_FLOAT(twin->left.y, l), LANE_FLOAT(twin->left.z, l));
    path->twin = TWIN_OUT;
}

// The walk of lane l is out, or lost, and its twin is not.
void control_part(const Scene *scene, PATH_SPACE Path *path, const TwinLanes *twin, uint l) {
    const float3 position =
        (float3)(LANE_FLOAT(twin->position.x, l), LANE_FLOAT(twin->position.y, l), LANE_FLOAT(twin->position.z, l));
    const float3 weight = (float3)(LANE_FLOAT(twin->weight.x, l), LANE_FLOAT(twin->weight.y, l), LANE_FLOAT(twin->weight.z, l));
    const float depth = path->outward.w - dot(path->outward.xyz, position);
    path->surplus.xyz -= weight * half_space_returns(scene, path, depth, dot(path->outward.xyz, path->direction.xyz));
    path->twin = TWIN_OUT;
}

#endif
