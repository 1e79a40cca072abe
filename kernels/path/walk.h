// A path's walk below the surface: in, through, and out again.
#ifndef NACRE_PATH_WALK_H
#define NACRE_PATH_WALK_H

#include "path/count.h"
#include "path/light.h"
#include "walk/boundary.h"
#include "walk/medium.h"
#include "walk/walk.h"

float3 scalar3(real3 v) { return (float3)(v.x, v.y, v.z); }

real3 lanes3(float3 v) {
    real3 r;
    r.x = v.x;
    r.y = v.y;
    r.z = v.z;
    return r;
}

Walk walk_load(const Path *path) {
    Walk walk;
    walk.position = lanes3(path->position.xyz);
    walk.direction = lanes3(path->direction.xyz);
    walk.weight = lanes3(path->weight.xyz);
    walk.share = lanes3(path->share.xyz);
    walk.sigma = lanes3(path->sigma.xyz);
    walk.albedo = lanes3(path->albedo.xyz);
    walk.anisotropy = path->anisotropy;
    walk.bleed = path->bleed;
    walk.reciprocal = path->flight == FLIGHT_RECIPROCAL;
    walk.channel = (int)path->channel;
    walk.first_number = path->first_number;
    walk.steps = path->steps;
    return walk;
}

void walk_store(const Walk *walk, Path *path) {
    path->position.xyz = scalar3(walk->position);
    path->direction.xyz = scalar3(walk->direction);
    path->weight.xyz = scalar3(walk->weight);
    path->share.xyz = scalar3(walk->share);
    path->channel = (uint)walk->channel;
    path->steps = walk->steps;
}

// Sends the path into the medium below `surface`, on the inner side of its geometric normal. Where a ray met the back of an
// open mesh that side is outside: the walk leaves at once, and the sheet shows the light of its other side.
void path_enter(const Scene *scene, Path *path, Sampler sampler, const Surface *surface, Counts *counts) {
    global const Material *material = scene->materials + scene->objects[surface->object].material;
    medium_at(scene, material, surface->uv, path);
    const float2 entry = draw_pair(sampler, DRAW_ENTRY), first = draw_pair(sampler, DRAW_FIRST);
    const float3 inner = material->entry == ENTRY_UNIFORM ? uniform_hemisphere(entry) : cosine_hemisphere(entry);
    const float3 inwards = -surface->geometric;
    path->direction.xyz = to_world(inner, inwards);
    path->position.xyz = surface->position;
    path->object = surface->object;
    path->first_number = first.y;
    path->depth = 1u;
    path->state = PATH_WALK;
    Walk walk = walk_load(path);
    walk_begin(scene, &walk, first.x);
    walk_store(&walk, path);
    counts->value[COUNTER_walks] += 1u;
}

// Out at `position`: lit there with Lambert's response about `shading`, without surface colour.
void path_exit(const Scene *scene, Path *path, const Walk *walk, float3 position, float3 error, float3 shading,
               float3 geometric, Counts *counts) {
    const Sampler sampler = sampler_of(scene->frame->seed, path->pixel, path->sample, path->vertex);
    path->throughput.xyz *= scalar3(walk->weight);
    path->state = PATH_RAY;
    light_lambert(scene, path, sampler, position, error, shading, geometric, counts);
    path->direction.xyz = lambert_sample(draw_pair(sampler, DRAW_DIRECTION), shading, geometric);
    path->direction.w = lambert_pdf(path->direction.xyz, shading, geometric);
    path->position.xyz = offset_point(position, error, geometric, path->direction.xyz);
    path->vertex += 1u;
}

void path_lose(Path *path, Counts *counts, int reason) {
    counts->value[reason] += 1u;
    path->state = PATH_DONE;
}

// Takes up to `budget` flights; returns how many. The path is then out, done, or still inside.
uint path_walk(const Scene *scene, Path *path, uint budget, Counts *counts) {
    Walk walk = walk_load(path);
    const Sampler sampler = sampler_of(scene->frame->seed, path->pixel, path->sample, path->vertex);
    global const Object *object = scene->objects + path->object;
    const float radius = scene->frame->scene_radius;
    const float beyond = 4.0f * radius;              // longer than any way through the scene
    const float outside2 = 1.01f * radius * radius; // no object reaches there
    uint steps = 0u;
    while (steps < budget && path->state == PATH_WALK) {
        steps += 1u;
        const uint4 words = draw_bits(sampler, DRAW_WALK, walk.steps);
        if (walk_chooses(scene))
            walk_choose(scene, &walk, random_unit(draw_bits(sampler, DRAW_WALK_CHANNEL, walk.steps).x));
        const float number = walk.steps == 0u ? path->first_number : random_unit(words.x);
        const float length = walk_distance(scene, &walk, number);
        const float3 origin = scalar3(walk.position), direction = scalar3(walk.direction);
        const Boundary boundary =
            boundary_follow(scene, object->walk_root, origin, direction, fmin(length, beyond), path->depth);
        counts->value[COUNTER_walk_rays] += boundary.rays;
        path->depth = boundary.depth;
        if (boundary.left) {
            walk_leave(scene, &walk, boundary.distance);
            const Surface surface = surface_at(scene, boundary.ray, boundary.hit);
            path_exit(scene, path, &walk, surface.position, surface.error, surface.shading, surface.geometric, counts);
            break;
        }
        if (length >= beyond || dot(origin, origin) > outside2) {
            if (!object->closed) {
                path_lose(path, counts, COUNTER_escaped);
                break;
            }
            // Rounding let it slip through a closed surface: it leaves where it is, the way it flies.
            counts->value[COUNTER_missed] += 1u;
            path_exit(scene, path, &walk, origin, (float3)(0.0f), direction, direction, counts);
            break;
        }
        walk_scatter(scene, &walk, length, random_unit(words.y), random_unit(words.z));
        if (!bits(walk_roulette(&walk, random_unit(words.w)))) {
            const float sum = walk.weight.x + walk.weight.y + walk.weight.z;
            if (!isfinite(sum)) path->radiance.xyz = sum; // so that it is counted, not hidden
            path_lose(path, counts, COUNTER_roulette);
            break;
        }
        if (path->max_depth != 0u && walk.steps >= path->max_depth) {
            const float3 lost = path->throughput.xyz * scalar3(walk.weight);
            counts->value[COUNTER_capped_energy] += (uint)fmin(1e9f, (lost.x + lost.y + lost.z) * (COUNTER_ENERGY / 3.0f));
            path_lose(path, counts, COUNTER_capped);
            break;
        }
    }
    if (path->state == PATH_WALK) walk_store(&walk, path);
    path->steps = walk.steps;
    counts->value[COUNTER_steps] += steps;
    return steps;
}

#endif
