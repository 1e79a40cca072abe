// One path per work-item, from beginning to end: for devices whose work-items are lanes already.
#ifndef NACRE_PATH_SINGLE_H
#define NACRE_PATH_SINGLE_H

#include "path/source.h"

// Steps that a ray and its shading cost in the budget of a launch, against one flight of a walk.
#define PATH_RAY_COST 8u

void single_light(const Scene *scene, Path *path, const Shadow *shadow, Counts *counts) {
    if (!shadow_asked(shadow)) return;
    counts->value[COUNTER_shadow_rays] += 1u;
    if (!trace_any(shadow->ray, scene->nodes, scene->blocks,
                   scene->frame->bvh_root PROFILED(, counts->profile + PROFILE_shadow_nodes)))
        path->radiance.xyz += shadow->light;
}

// Takes up to `budget` flights; returns how many. The path is then out, done, or still inside.
uint single_walk(const Scene *scene, Path *path, uint budget, Counts *counts) {
    WalkLanes lanes;
    RayStream stream;
    lane_load(scene, &lanes, 0u, path, 0u);
    for (uint steps = 1u; steps <= budget; steps++) {
        const TurnEnds ends = walk_turn(scene, &lanes, &stream, 1u, counts);
        if ((ends.left | ends.slipped | ends.ended | ends.capped) == 0u) continue;
        const Shadow shadow = lane_end(scene, &lanes, &stream, 0u, ends, path, counts);
        single_light(scene, path, &shadow, counts);
        return steps;
    }
    lane_store(&lanes, 0u, path);
    return budget;
}

// Goes on until the path is done or has used up its budget.
void single_advance(const Scene *scene, Path *path, uint budget, Counts *counts, global float4 *layers) {
    uint used = 0u;
    while (path->state != PATH_DONE && used < budget) {
        if (path->state == PATH_RAY) {
            const Ray ray = path_ray(path->position.xyz, path->direction.xyz);
            const Hit hit = trace_closest(ray, scene->nodes, scene->blocks,
                                          scene->frame->bvh_root PROFILED(, counts->profile + PROFILE_ray_nodes));
            const Shadow shadow = path_meet(scene, path, hit, counts, layers);
            single_light(scene, path, &shadow, counts);
            used += PATH_RAY_COST;
        } else {
            used += single_walk(scene, path, budget - used, counts);
        }
    }
}

// A path over its budget is suspended where there is room for it.
void trace_single(const Scene *scene, const Launch *launch, uint i, Counts *counts) {
    Path path;
    if (i >= launch_paths(launch) || !launch_path(scene, launch, i, &path, counts)) return;
    do {
        single_advance(scene, &path, launch->batch.budget, counts, launch->layers + 2u * path.slot);
    } while (path.state != PATH_DONE && !launch_suspend(launch, &path));
    if (path.state == PATH_DONE) launch_take(launch, &path, counts);
}

#endif
