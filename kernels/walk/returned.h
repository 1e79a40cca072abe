// What a half-space or a slab returns of light inside it, in the mean: from tables that the host has found (shared/returned.h).
#ifndef NACRE_WALK_RETURNED_H
#define NACRE_WALK_RETURNED_H

#include "shared/returned.h"
#include "walk/medium.h"

// Depth of a table's node, in transport mean free paths.
float returned_depth(uint node) {
    const float x = (float)node * (1.0f / (RETURNED_DEPTHS - 1)), x2 = x * x;
    return RETURNED_DEEPEST * x2 * x2;
}

// Beyond the last node the logarithm goes on in a straight line.
TablePlace returned_place(float depth) {
    TablePlace place;
    place.node = min((uint)(sqrt(sqrt(depth / RETURNED_DEEPEST)) * (float)(RETURNED_DEPTHS - 1)), RETURNED_DEPTHS - 2u);
    const float above = returned_depth(place.node);
    place.share = (depth - above) / (returned_depth(place.node + 1u) - above);
    return place;
}

float slab_depth(uint node) {
    const float x = (float)node * (1.0f / (RETURNED_SLAB_DEPTHS - 1));
    return x < 0.5f ? 2.0f * x * x : 1.0f - 2.0f * (1.0f - x) * (1.0f - x);
}

// `depth`: over the thickness.
TablePlace slab_place(float depth) {
    const float clamped = clamp(depth, 0.0f, 1.0f), x = sqrt(0.5f * min(clamped, 1.0f - clamped));
    TablePlace place;
    place.node = min((uint)((clamped < 0.5f ? x : 1.0f - x) * (float)(RETURNED_SLAB_DEPTHS - 1)), RETURNED_SLAB_DEPTHS - 2u);
    const float above = slab_depth(place.node);
    place.share = (clamped - above) / (slab_depth(place.node + 1u) - above);
    return place;
}

// Logarithm of the share, of one channel, from a table of `rows` depths. `first`: where it is, as if from similarity 0 on.
float returned_log(const Scene *scene, global const float *tables, int first, uint rows, float albedo, float g, TablePlace depth,
                   TablePlace cosine) {
    const float losses = max(0.0f, 1.0f - albedo);
    const TablePlace s = table_place(sqrt(losses / max(1e-6f, 1.0f - albedo * g)) * (RETURNED_SIMILARITIES - 1),
                                     RETURNED_SIMILARITIES);
    const uint next = HAS(ANISOTROPY) ? 1u : 0u, row = HAS(ANISOTROPY) ? RETURNED_COSINES : 1u, layer = row * rows;
    global const float *at = tables + (first + (int)(s.node * layer + depth.node * row + cosine.node));
    const float low = mix(mix(at[0], at[next], cosine.share), mix(at[row], at[row + next], cosine.share), depth.share);
    at += layer;
    const float high = mix(mix(at[0], at[next], cosine.share), mix(at[row], at[row + next], cosine.share), depth.share);
    return mix(low, high, s.share);
}

TablePlace returned_cosine(const Scene *scene, float cosine) {
    TablePlace place = {0u, 0.0f};
    if (HAS(ANISOTROPY)) place = table_place((cosine + 1.0f) * (0.5f * (RETURNED_COSINES - 1)), RETURNED_COSINES);
    return place;
}

// The share per channel of what scatters at `depth` (in the scene's units) in the path's medium.
float3 half_space_returns(const Scene *scene, const PATH_SPACE Path *path, float depth, float cosine) {
    global const int *first = scene->materials[scene->objects[path->object].material].returned_first;
    const TablePlace place = returned_cosine(scene, cosine);
    const float3 albedo = path->albedo.xyz, g = path->anisotropy.xyz;
    const float3 depths = max(0.0f, depth) * path->sigma.xyz * (1.0f - g); // in transport mean free paths
    global const float *tables = scene->returned;
    return (float3)(
        exp_scalar(returned_log(scene, tables, first[0], RETURNED_DEPTHS, albedo.x, g.x, returned_place(depths.x), place)),
        exp_scalar(returned_log(scene, tables, first[1], RETURNED_DEPTHS, albedo.y, g.y, returned_place(depths.y), place)),
        exp_scalar(returned_log(scene, tables, first[2], RETURNED_DEPTHS, albedo.z, g.z, returned_place(depths.z), place)));
}

float3 slab_share(const Scene *scene, const PATH_SPACE Path *path, global const Slab *slab, TablePlace depth, TablePlace cosine) {
    const float3 albedo = path->albedo.xyz, g = path->anisotropy.xyz;
    global const float *tables = scene->transmitted;
    return (float3)(
        exp_scalar(returned_log(scene, tables, slab->first[0], RETURNED_SLAB_ROWS, albedo.x, g.x, depth, cosine)),
        exp_scalar(returned_log(scene, tables, slab->first[1], RETURNED_SLAB_ROWS, albedo.y, g.y, depth, cosine)),
        exp_scalar(returned_log(scene, tables, slab->first[2], RETURNED_SLAB_ROWS, albedo.z, g.z, depth, cosine)));
}

// What leaves a slab through one side of light that scatters at `depth` below it, whose cosine towards it is `cosine`.
float3 slab_returns(const Scene *scene, const PATH_SPACE Path *path, global const Slab *slab, float depth, float cosine) {
    return slab_share(scene, path, slab, slab_place(depth / slab->thickness), returned_cosine(scene, cosine));
}

// What comes back from a slab of light that enters it with Lambert's cosine, or gets through.
float3 slab_shows(const Scene *scene, const PATH_SPACE Path *path, global const Slab *slab, bool through) {
    const TablePlace row = {RETURNED_SLAB_DEPTHS, through ? 1.0f : 0.0f}, any = {0u, 0.0f};
    return slab_share(scene, path, slab, row, any);
}

#endif
