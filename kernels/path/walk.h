// A path's way into the medium and out of it, and its place among the lanes between the two.
#ifndef NACRE_PATH_WALK_H
#define NACRE_PATH_WALK_H

#include "film/layers.h"
#include "guide/load.h"
#include "path/interface.h"
#include "path/control.h"
#include "walk/medium.h"
#include "walk/turn.h"

// The path is to walk, from below `surface`.
void path_below(const Scene *scene, PATH_SPACE Path *path, const Surface *surface) {
    path->state = PATH_WALK;
    if (GUIDED || HAS(CONTROL))
        path->outward = (float4)(surface->geometric, dot(surface->geometric, surface->position));
    if (GUIDED && scene->objects[path->object].guided > 0.0f) guide_begin(scene, path, surface);
}

// Sends the path into the medium below `surface`, on the inner side of its geometric normal. Where a ray met the back of an
// open mesh that side is outside: the walk leaves at once, and the sheet shows the light of its other side.
void path_enter(const Scene *scene, PATH_SPACE Path *path, Sampler sampler, const Surface *surface, uint twin,
                Counts *counts) {
    global const Material *material = scene->materials + scene->objects[surface->object].material;
    const float3 shown = medium_at(scene, material, surface->uv, path);
    const float2 entry = draw_pair(sampler, DRAW_ENTRY), first = draw_pair(sampler, DRAW_FIRST);
    if (HAS(INTERFACE) && material->entry == ENTRY_REFRACTED) {
        path->direction.xyz = interface_enter(scene, material, surface, path, sampler);
    } else {
        const float3 inner = material->entry == ENTRY_UNIFORM ? uniform_hemisphere(entry) : cosine_hemisphere(entry);
        path->direction.xyz = to_world(inner, -surface->geometric);
    }
    if (HAS(INTERFACE)) path->scatters = 0u;
    path->position.xyz = surface->position;
    path->object = surface->object;
    path->first_number = first.y;
    path->depth = 1u;
    path->steps = 0u;
    path_below(scene, path, surface);
    // The walk takes the colour of the path along; a black path (its roulette will end it) has none.
    const float heaviest = largest3(path->throughput.xyz);
    float3 color = (float3)(1.0f);
    if (heaviest > 0.0f) {
        color = path->throughput.xyz * (1.0f / heaviest);
        path->throughput.xyz = (float3)(heaviest);
    }
    const WalkStart start = walk_start(scene, color, shown, first.x);
    path->weight.xyz = start.weight;
    path->share.xyz = start.share;
    path->channel = start.channel;
    if (HAS(CONTROL)) control_begin(scene, path, twin, color, shown);
    counts->value[COUNTER_walks] += 1u;
}

// Out at `position`: lit there with Lambert's response about `shading`, without surface colour.
Shadow path_exit(const Scene *scene, PATH_SPACE Path *path, float3 position, float3 error, float3 shading, float3 geometric) {
    const Sampler sampler = HAS(CONTROL) && path->twin != TWIN_NONE ? control_sampler(path) : path_sampler(path);
    path->throughput.xyz *= path->weight.xyz;
    path->state = PATH_RAY;
    const Shadow shadow = light_lambert(scene, path->throughput.xyz, sampler, position, error, shading, geometric);
    path->direction.xyz = lambert_sample(draw_pair(sampler, DRAW_DIRECTION), shading, geometric);
    path->direction.w = lambert_pdf(path->direction.xyz, shading, geometric);
    path->position.xyz = offset_point(position, error, geometric, path->direction.xyz);
    path->outward.xyz = geometric;
    path->vertex += 1u;
    return shadow;
}

void path_lose(PATH_SPACE Path *path, Counts *counts, int reason) {
    counts->value[reason] += 1u;
    path->state = PATH_DONE;
}

// Puts the walk of a path into lane l. `at` is where the path itself is kept.
void lane_load(const Scene *scene, WalkLanes *lanes, uint l, const PATH_SPACE Path *path, uint at) {
    Walk *walk = &lanes->walk;
    LANE_FLOAT(walk->position.x, l) = path->position.x;
    LANE_FLOAT(walk->position.y, l) = path->position.y;
    LANE_FLOAT(walk->position.z, l) = path->position.z;
    LANE_FLOAT(walk->direction.x, l) = path->direction.x;
    LANE_FLOAT(walk->direction.y, l) = path->direction.y;
    LANE_FLOAT(walk->direction.z, l) = path->direction.z;
    LANE_FLOAT(walk->weight.x, l) = path->weight.x;
    LANE_FLOAT(walk->weight.y, l) = path->weight.y;
    LANE_FLOAT(walk->weight.z, l) = path->weight.z;
    LANE_FLOAT(walk->share.x, l) = path->share.x;
    LANE_FLOAT(walk->share.y, l) = path->share.y;
    LANE_FLOAT(walk->share.z, l) = path->share.z;
    LANE_FLOAT(walk->sigma.x, l) = path->sigma.x;
    LANE_FLOAT(walk->sigma.y, l) = path->sigma.y;
    LANE_FLOAT(walk->sigma.z, l) = path->sigma.z;
    LANE_FLOAT(walk->albedo.x, l) = path->albedo.x;
    LANE_FLOAT(walk->albedo.y, l) = path->albedo.y;
    LANE_FLOAT(walk->albedo.z, l) = path->albedo.z;
    LANE_FLOAT(walk->anisotropy.x, l) = path->anisotropy.x;
    if (HAS(ANISOTROPY_RGB)) {
        LANE_FLOAT(walk->anisotropy.y, l) = path->anisotropy.y;
        LANE_FLOAT(walk->anisotropy.z, l) = path->anisotropy.z;
    }
    LANE_FLOAT(walk->bleed, l) = path->bleed;
    LANE_INT(walk->reciprocal, l) = path->flight == FLIGHT_RECIPROCAL ? MASK_TRUE : 0;
    LANE_INT(walk->channel, l) = (int)path->channel;
    LANE_FLOAT(walk->first_number, l) = path->first_number;
    LANE_UINT(walk->steps, l) = path->steps;
    const Sampler sampler = path_sampler(path);
    LANE_UINT(lanes->sampler.key, l) = sampler.key;
    LANE_UINT(lanes->sampler.sample, l) = sampler.sample;
    LANE_UINT(lanes->sampler.vertex, l) = sampler.vertex;
    global const Object *object = scene->objects + path->object;
    LANE_UINT(lanes->root, l) = object->walk_root;
    LANE_UINT(lanes->depth, l) = path->depth;
    LANE_UINT(lanes->max_depth, l) = path->max_depth;
    LANE_UINT(lanes->path, l) = at;
    LANE_FLOAT(lanes->clear, l) = 0.0f;
    if (HAS(CLEARANCE)) clearance_set(&lanes->field, l, &object->clearance);
    if (GUIDED || HAS(CONTROL)) plane_load(&lanes->guide, l, path);
    if (GUIDED) guide_load(scene, &lanes->guide, l, path);
    if (HAS(CONTROL)) twin_load(scene, &lanes->twin, l, path);
}

// Takes what a walk changes back into its path.
void lane_store(const WalkLanes *lanes, uint l, PATH_SPACE Path *path) {
    const Walk *walk = &lanes->walk;
    path->position.xyz =
        (float3)(LANE_FLOAT(walk->position.x, l), LANE_FLOAT(walk->position.y, l), LANE_FLOAT(walk->position.z, l));
    path->direction.xyz =
        (float3)(LANE_FLOAT(walk->direction.x, l), LANE_FLOAT(walk->direction.y, l), LANE_FLOAT(walk->direction.z, l));
    path->weight.xyz = (float3)(LANE_FLOAT(walk->weight.x, l), LANE_FLOAT(walk->weight.y, l), LANE_FLOAT(walk->weight.z, l));
    path->share.xyz = (float3)(LANE_FLOAT(walk->share.x, l), LANE_FLOAT(walk->share.y, l), LANE_FLOAT(walk->share.z, l));
    path->channel = (uint)LANE_INT(walk->channel, l);
    path->steps = LANE_UINT(walk->steps, l);
    path->depth = LANE_UINT(lanes->depth, l);
    path->tries = LANE_UINT(lanes->guide.tries, l);
}

// What became of walk w of a turn, one of those that `ends` names: out, lost, or turned back at the surface. `layers`: of its path.
Shadow walk_end(const Scene *scene, const WalkLanes *groups, const RayStream *stream, uint w, TurnEnds ends, PATH_SPACE Path *path,
                Counts *counts, global float4 *layers) {
    const Walks bit = (Walks)1 << w;
    bool out = (ends.left & bit) != 0;
    float3 position = path->position.xyz, error = (float3)(0.0f), shading = path->direction.xyz, geometric = shading;
    if (out) {
        const Ray ray = stream_ray(stream, w);
        const Surface surface = surface_at(scene, ray, stream_hit(stream, scene->blocks, w));
        if (HAS(INTERFACE) && interface_holds(scene, &surface, ray.direction, path)) {
            path_below(scene, path, &surface);
            return no_shadow();
        }
        position = surface.position;
        error = surface.error;
        shading = surface.shading;
        geometric = surface.geometric;
    }
    COUNT_WALK(counts, path->scatters + path->steps + (out ? 1u : 0u)) // flights: the one that left, too
    if (HAS(SCATTER_AOV)) layers_walked(scene, layers, path->radiance.xyz, path->scatters + path->steps);
    if (ends.slipped & bit) {
        if (!scene->objects[path->object].closed) {
            path_lose(path, counts, COUNTER_escaped);
            return no_shadow();
        }
        // Rounding let it slip through a closed surface: it leaves where it is, the way it flies.
        counts->value[COUNTER_missed] += 1u;
        out = true;
    }
    if (out) return path_exit(scene, path, position, error, shading, geometric);
    if (ends.capped & bit) {
        const float3 lost = path->throughput.xyz * path->weight.xyz;
        counts->value[COUNTER_capped_energy] += (uint)min(1e9f, (lost.x + lost.y + lost.z) * (COUNTER_ENERGY / 3.0f));
        path_lose(path, counts, COUNTER_capped);
        return no_shadow();
    }
    const float sum = path->weight.x + path->weight.y + path->weight.z;
    if (!isfinite(sum)) path->radiance.xyz = sum; // so that it is counted, not hidden
    path_lose(path, counts, COUNTER_roulette);
    return no_shadow();
}

// The same, with its twin.
Shadow lane_end(const Scene *scene, const WalkLanes *groups, const RayStream *stream, uint w, TurnEnds ends, PATH_SPACE Path *path,
                Counts *counts, global float4 *layers) {
    const WalkLanes *lanes = GROUP(groups, w / LANES);
    const uint l = w % LANES;
    lane_store(lanes, l, path);
    if (HAS(CONTROL) && (ends.parted >> w & 1u) != 0u) control_part(scene, path, &lanes->twin, l);
    return walk_end(scene, groups, stream, w, ends, path, counts, layers);
}

#endif
