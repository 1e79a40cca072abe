// Entry points of the renderer. Their names are stable, for profilers.
#include "film/accumulate.h"
#include "path/path.h"

// A sample that is NaN or infinite becomes black; it is counted, and the first is remembered.
float4 finite_or_counted(Path path, Counts *counts, volatile global uint *counters) {
    const float sum = path.radiance.x + path.radiance.y + path.radiance.z;
    if (isfinite(sum)) return path.radiance;
    counts->value[COUNTER_non_finite] += 1u;
    if (atomic_cmpxchg(counters + COUNTER_BAD_PIXEL, 0u, path.pixel + 1u) == 0u) {
        counters[COUNTER_BAD_SAMPLE] = path.sample;
        counters[COUNTER_BAD_STEP] = path.vertex << 24 | min(path.steps, 0xffffffu);
    }
    return (float4)(0.0f, 0.0f, 0.0f, path.radiance.w);
}

// Traces a batch: work-item i takes pixel i / sample_count, sample i % sample_count; or goes on with suspended path i. A path
// over its budget is suspended where there is room for it.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void trace_paths(
    SCENE_PARAMETERS, Batch batch, global float4 *radiance, global float4 *layers, global const Path *resumed,
    global Path *suspended, volatile global uint *counters) {
    const Scene view = {SCENE_ARGUMENTS}, *scene = &view;
    const uint i = get_global_id(0);
    Counts counts = no_counts();
    Path path;
    if (batch.resumed > 0u) {
        if (i >= batch.resumed) return;
        path = resumed[i];
    } else {
        if (i >= batch.pixel_count * batch.sample_count) return;
        uint x, y;
        if (!pixel_at(scene, batch.first_pixel + i / batch.sample_count, &x, &y)) return;
        path = path_begin(scene, x, y, batch.first_sample + i % batch.sample_count, i);
        counts.value[COUNTER_paths] += 1u;
        if (HAS(SURFACE_AOV)) layers[2u * i] = layers[2u * i + 1u] = (float4)(0.0f);
    }
    for (;;) {
        path_advance(scene, &path, batch.budget, &counts, layers + 2u * path.slot);
        if (path.state == PATH_DONE) {
            radiance[path.slot] = finite_or_counted(path, &counts, counters);
            break;
        }
        const uint at = atomic_inc(counters + COUNTER_SUSPENDED);
        if (at < batch.capacity) {
            suspended[at] = path;
            break;
        }
    }
    add_counts(&counts, counters);
}

// Adds a traced batch to the film, `planes` float4 per pixel of the tile order.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void accumulate(
    SCENE_PARAMETERS, Batch batch, global const float4 *radiance, global const float4 *layers, global float4 *film,
    uint planes) {
    const Scene view = {SCENE_ARGUMENTS}, *scene = &view;
    const uint i = get_global_id(0);
    uint x, y;
    if (i >= batch.pixel_count || !pixel_at(scene, batch.first_pixel + i, &x, &y)) return;
    film_accumulate(batch.first_pixel + i, batch.sample_count, i * batch.sample_count, radiance, layers, planes, film);
}

// Sizes of the shared structs as the device sees them; the host compares.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void layout(global uint *sizes) {
    if (get_global_id(0) != 0) return;
    sizes[0] = sizeof(Camera);
    sizes[1] = sizeof(Material);
    sizes[2] = sizeof(Texture);
    sizes[3] = sizeof(Object);
    sizes[4] = sizeof(Light);
    sizes[5] = sizeof(AliasEntry);
    sizes[6] = sizeof(Frame);
    sizes[7] = sizeof(Path);
    sizes[8] = sizeof(Batch);
}
