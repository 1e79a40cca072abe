// Entry points of the renderer. Their names are stable, for profilers.
#include "exact/builtins.h"
#include "film/accumulate.h"
#include "guide/sides.h"
#include "guide/thickness.h"
#include "path/source.h"
#if LANES == 1
#include "path/single.h"
#else
#include "path/worker.h"
#endif

// Traces a batch, or goes on with suspended paths. Each work-item takes one path, or with LANES > 1 as many as it can get:
// then there are few of them, with `pool` as their store.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void trace_paths(
    SCENE_PARAMETERS, Batch batch, global float4 *radiance, global float4 *layers, global const Path *resumed,
    global Path *suspended, volatile global uint *counters, global Path *pool AND_LISTED(global const uint *tiles)) {
    const Scene view = {SCENE_ARGUMENTS}, *scene = &view;
    const Launch launch = {batch, radiance, layers, resumed, suspended, counters AND_LISTED(tiles)};
    Counts counts = no_counts();
#if LANES == 1
    trace_single(scene, &launch, get_global_id(0), &counts);
#else
    trace_many(scene, &launch, pool + get_global_id(0) * POOL_PATHS, &counts);
#endif
    add_counts(&counts, counters);
}

// Adds a traced batch to the film, `planes` float4 per pixel of the tile order.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void accumulate(
    SCENE_PARAMETERS, Batch batch, global const float4 *radiance, global const float4 *layers, global float4 *film,
    uint planes AND_LISTED(global const uint *tiles)) {
    const Scene view = {SCENE_ARGUMENTS}, *scene = &view;
    const uint i = get_global_id(0);
    if (i >= batch.pixel_count) return;
    uint x, y, pixel = batch.first_pixel + i;
    LISTED(pixel = listed_pixel(tiles, pixel);)
    if (!pixel_at(scene, pixel, &x, &y)) return;
    film_accumulate(scene, batch.first_pixel + i, batch.sample_count, i * batch.sample_count, radiance, layers, planes, film);
}

// Direct light on points of surfaces, each given as a position and a unit normal: SIDE_SAMPLES samples of it per point.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void light_points(
    SCENE_PARAMETERS, global const float4 *points, uint count, global float *irradiance) {
    const Scene view = {SCENE_ARGUMENTS}, *scene = &view;
    const uint i = get_global_id(0);
    if (i < count) irradiance[i] = side_light(scene, i, points[2u * i].xyz, points[2u * i + 1u].xyz);
}

// Thickness of an object below each of its primitives. Each work-item takes one slot of its tree's blocks, from the first on.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void object_thickness(
    SCENE_PARAMETERS, uint object, uint first_block, uint count, global float *found) {
    const uint i = get_global_id(0), block = first_block + i / BVH_WIDTH, slot = i % BVH_WIDTH;
    if (i >= count) return;
    const uint primitive = block_primitive(blocks, block, slot);
    if (primitive != BVH_NO_PRIMITIVE)
        found[primitive] = thickness_below(nodes, blocks, objects[object].walk_root, block, slot);
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
    sizes[9] = sizeof(Clearance);
    sizes[10] = sizeof(GuideMode);
    sizes[11] = sizeof(LightSides);
    sizes[12] = sizeof(Slab);
}
