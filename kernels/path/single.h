// One path per work-item, from beginning to end: for devices whose work-items are lanes already.
#ifndef NACRE_PATH_SINGLE_H
#define NACRE_PATH_SINGLE_H

#include "path/source.h"

// Steps that a ray and its shading cost in the budget of a launch, against one flight of a walk.
#define PATH_RAY_COST 8u

void single_light(const Scene *scene, PATH_SPACE Path *path, const Shadow *shadow, Counts *counts) {
    if (!shadow_asked(scene, shadow)) return;
    counts->value[COUNTER_shadow_rays] += 1u;
    if (!trace_any(shadow->ray, scene->nodes, scene->blocks,
                   scene->frame->bvh_root AND_PROFILED(counts->profile + PROFILE_shadow_nodes)))
        shadow_light(scene, path, shadow->light, shadow->foreseen, shadow->across);
}

// Takes up to *budget flights and counts them down. The path is then out, done, or still inside. Returns the direct light of
// its exit that is yet to be asked for.
Shadow single_walk(const Scene *scene, PATH_SPACE Path *path, uint *budget, Counts *counts, global float4 *layers) {
    WalkLanes lanes;
    RayStream stream;
    lane_load(scene, &lanes, 0u, path, 0u);
    for (; *budget > 0u; *budget -= 1u) {
        const TurnEnds ends = walk_turn(scene, &lanes, &stream, 1u, counts);
        if (HAS(CONTROL) && ends.twins != 0u) control_take(scene, path, &lanes.twin, 0u);
        if (turn_ended(ends) == 0u) continue;
        *budget -= 1u;
        return lane_end(scene, &lanes, &stream, 0u, ends, path, counts, layers);
    }
    lane_store(&lanes, 0u, path);
    return no_shadow();
}

// Goes on until the path is done or has used up its budget.
void single_advance(const Scene *scene, PATH_SPACE Path *path, uint budget, Counts *counts, global float4 *layers) {
    while (path->state != PATH_DONE && budget > 0u) {
        Shadow shadow, more[CONTROL_SHADOWS];
        uint count = 0u;
        if (path->state == PATH_RAY) {
            const Hit hit = trace_closest(path_ray(path->position.xyz, path->direction.xyz), scene->nodes, scene->blocks,
                                          scene->frame->bvh_root AND_PROFILED(counts->profile + PROFILE_ray_nodes));
            Surface surface;
            shadow = path_meet(scene, path, hit, &surface, false, counts, layers);
            if (HAS(CONTROL) && path->state == PATH_WALK && path->twin != TWIN_NONE)
                count = control_foresee(scene, path, &surface, more);
            budget -= min(budget, PATH_RAY_COST);
        } else if (HAS(DIFFUSION_MODEL) && path->state == PATH_PROBE) {
            shadow = diffusion_leave(scene, path, counts);
            budget -= min(budget, PATH_RAY_COST);
        } else {
            shadow = single_walk(scene, path, &budget, counts, layers);
        }
        for (uint i = 0;; i++) { // in one place: rays are much code
            single_light(scene, path, &shadow, counts);
            if (i == count) break;
            shadow = more[i];
        }
    }
}

// A path over its budget is suspended where there is room for it.
void trace_single(const Scene *scene, const Launch *launch, uint i, Counts *counts) {
    Path path;
    if (i >= launch_paths(launch) || !launch_path(scene, launch, i, &path, 0, counts)) return;
    do {
        single_advance(scene, &path, launch->batch.budget, counts, launch_layers(scene, launch, path.slot));
    } while (path.state != PATH_DONE && !launch_suspend(launch, &path));
    if (path.state == PATH_DONE) launch_take(scene, launch, &path, counts);
}

#endif
