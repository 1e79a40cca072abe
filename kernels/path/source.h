// Where a launch's paths come from: the pixels of its batch, or paths that an earlier launch suspended. And where they end.
#ifndef NACRE_PATH_SOURCE_H
#define NACRE_PATH_SOURCE_H

#include "path/path.h"

// Where pixel `index` of the list is in the tile order.
uint listed_pixel(global const uint *tiles, uint index) {
    return (tiles[index / (TILE * TILE)] & ~SECOND_HALF) * (TILE * TILE) + index % (TILE * TILE);
}

typedef struct {
    Batch batch;
    global float4 *radiance; // one per slot of the batch
    global float4 *layers;   // layers_each per slot
    global const Path *resumed;
    global Path *suspended;
    volatile global uint *counters;
    LISTED(global const uint *tiles;)
} Launch;

uint launch_paths(const Launch *launch) {
    return launch->batch.resumed > 0u ? launch->batch.resumed : launch->batch.pixel_count * launch->batch.sample_count;
}

global float4 *launch_layers(const Scene *scene, const Launch *launch, uint slot) {
    return launch->layers + layers_each(scene) * slot;
}

// Path i of the launch: pixel i / sample_count, sample i % sample_count, or a suspended one. False: beyond the crop's edge.
// `before`: one that has begun and whose camera ray may serve this one, too, or null.
bool launch_path(const Scene *scene, const Launch *launch, uint i, PATH_SPACE Path *path, const PATH_SPACE Path *before,
                 Counts *counts) {
    if (launch->batch.resumed > 0u) {
        *path = launch->resumed[i];
        return true;
    }
    uint x, y, pixel = launch->batch.first_pixel + i / launch->batch.sample_count;
    uint sample = launch->batch.first_sample + i % launch->batch.sample_count;
    LISTED(sample |= launch->tiles[pixel / (TILE * TILE)] & SECOND_HALF;)
    LISTED(pixel = listed_pixel(launch->tiles, pixel);)
    if (!pixel_at(scene, pixel, &x, &y)) return false;
    path_begin(scene, path, x, y, sample, i);
    if (before != 0 && path_shares_ray(scene, path, before)) {
        path->position = before->position;
        path->direction = before->direction;
    } else {
        path_aim(scene, path, x, y);
    }
    counts->value[COUNTER_paths] += 1u;
    layers_begin(scene, launch_layers(scene, launch, i));
    return true;
}

// About how long a path took, in flights of a walk; of its walks, the last. Beside the alpha of its radiance, which is 0 or 1.
float path_cost(const PATH_SPACE Path *path) {
    const uint cost = LIST_EVENT_COST * (path->vertex + 1u) + path->scatters + path->steps;
    return LIST_COST * (float)min(cost, LIST_MOST_COST);
}

// The radiance of a path that is done. A sample that is NaN or infinite becomes black; it is counted, and the first remembered.
void launch_take(const Scene *scene, const Launch *launch, const PATH_SPACE Path *path, Counts *counts) {
    float4 radiance = path->radiance;
    if (HAS(CONTROL)) radiance.xyz += path->foreseen.xyz * path->surplus.xyz;
    if (HAS(SLABS)) radiance.xyz += path->foreseen_across.xyz * path->surplus_across.xyz;
    LISTED(radiance.w += path_cost(path);)
    if (isfinite(radiance.x + radiance.y + radiance.z)) {
        launch->radiance[path->slot] = radiance;
        return;
    }
    launch->radiance[path->slot] = (float4)(0.0f, 0.0f, 0.0f, radiance.w);
    if (HAS(SCATTER_AOV)) layers_unwalked(scene, launch_layers(scene, launch, path->slot));
    counts->value[COUNTER_non_finite] += 1u;
    volatile global uint *counters = launch->counters;
    if (atomic_cmpxchg(counters + COUNTER_BAD_PIXEL, 0u, path->pixel + 1u) == 0u) {
        counters[COUNTER_BAD_SAMPLE] = path->sample;
        counters[COUNTER_BAD_STEP] = path->vertex << 24 | min(path->steps, 0xffffffu);
    }
}

// Keeps a path for the next launch. False: there is no room.
bool launch_suspend(const Launch *launch, const PATH_SPACE Path *path) {
    const uint at = atomic_inc(launch->counters + COUNTER_SUSPENDED);
    if (at >= launch->batch.capacity) return false;
    launch->suspended[at] = *path;
    return true;
}

#endif
