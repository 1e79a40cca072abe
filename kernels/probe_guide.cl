// Entry points that let tests see where guided walks turn, and what half-spaces return.
#include "guide/load.h"
#include "walk/returned.h"
#include "walk/walk.h"

// Scatters of walks that came from `from`, in a slab that they entered at the origin along z. place: depth, thickness, light
// on the far side over that on the near side, anisotropy. out: new direction; its density over the classical one.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void probe_turn(
    global const Frame *frame, global const GuideMode *mode, float4 from, float4 place, uint seed, uint count,
    global float4 *out) {
    Scene view = {frame};
    const Scene *scene = &view;
    const uint i = get_global_id(0);
    if (i >= count) return;
    Walk walk;
    walk.position = triple(0.0f);
    walk.position.z = place.x;
    walk.direction.x = from.x;
    walk.direction.y = from.y;
    walk.direction.z = from.z;
    walk.sigma = triple(1.0f);
    walk.anisotropy = triple(place.w);
    walk.bleed = 0.0f;
    walk.reciprocal = 0;
    const WalkStart start = walk_start(scene, (float3)(1.0f), (float3)(1.0f), 0.5f);
    walk_begin(&walk, start);
    walk.steps = 1u;
    GuideLanes guide;
    guide.outward = triple(0.0f);
    guide.outward.z = -1.0f;
    guide.offset = 0.0f;
    guide.thickness = place.y;
    guide.share = GUIDE_SHARE;
    guide.far_light = place.z;
    guide.tries = 0u;
    mode_load(scene, &guide.x, 0u, mode, place.w);
    guide.y = guide.x;
    guide.z = guide.x;
    const LaneSampler sampler = {seed, i, 0u};
    const uint4 words = random_hash((uint4)(seed, i, 1u, 11u)), choice = random_hash((uint4)(seed, i, 2u, 11u));
    const DirectionNumbers numbers = {random_unit(words.y), random_unit(words.z)};
    const real xi_technique = random_unit(choice.y), xi_length = random_unit(choice.z);
    while (walk_direct(scene, &walk, &guide, xi_technique, xi_length, numbers, sampler, 1u) != 0u) {}
    real density = guide.flight_x.direction; // dwivedi draws the direction apart from the length
    if (HAS(GUIDE_EIGEN)) density *= guide.flight_x.near + guide.flight_x.far + (1.0f - GUIDE_SHARE);
    out[i] = (float4)(walk.direction.x, walk.direction.y, walk.direction.z, density);
}

// What a half-space returns, from the table that begins at `first`. points: albedo, anisotropy, depth in mean free paths, cosine.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void probe_returned(
    global const Frame *frame, global const float *returned, int first, global const float4 *points, uint count,
    global float *out) {
    Scene view = {frame};
    view.returned = returned;
    const uint i = get_global_id(0);
    if (i >= count) return;
    const TablePlace cosine = returned_cosine(&view, points[i].w);
    out[i] = exp_scalar(returned_log(&view, returned, first, RETURNED_DEPTHS, points[i].x, points[i].y,
                                     returned_place(points[i].z * (1.0f - points[i].y)), cosine));
}
