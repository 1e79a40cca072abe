// What a half-space returns of light inside it, in the mean: from tables that the host has found (shared/returned.h).
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

// Logarithm of the share, of one channel. `first`: its table, as if from similarity 0 on; depth: in mean free paths.
float returned_log(const Scene *scene, int first, float albedo, float g, float depth, TablePlace cosine) {
    const float losses = fmax(1.0f - albedo, 0.0f);
    const TablePlace s = table_place(sqrt(losses / fmax(1.0f - albedo * g, 1e-6f)) * (RETURNED_SIMILARITIES - 1),
                                     RETURNED_SIMILARITIES);
    const TablePlace z = returned_place(depth * (1.0f - g));
    const uint next = HAS(ANISOTROPY) ? 1u : 0u, row = HAS(ANISOTROPY) ? RETURNED_COSINES : 1u, layer = row * RETURNED_DEPTHS;
    global const float *at = scene->returned + (first + (int)(s.node * layer + z.node * row + cosine.node));
    const float low = mix(mix(at[0], at[next], cosine.share), mix(at[row], at[row + next], cosine.share), z.share);
    at += layer;
    const float high = mix(mix(at[0], at[next], cosine.share), mix(at[row], at[row + next], cosine.share), z.share);
    return mix(low, high, s.share);
}

TablePlace returned_cosine(const Scene *scene, float cosine) {
    TablePlace place = {0u, 0.0f};
    if (HAS(ANISOTROPY)) place = table_place((cosine + 1.0f) * (0.5f * (RETURNED_COSINES - 1)), RETURNED_COSINES);
    return place;
}

// The share per channel of what scatters at `depth` (in the scene's units) in the path's medium.
float3 half_space_returns(const Scene *scene, const PATH_SPACE Path *path, float depth, float cosine) {
    global const Material *material = scene->materials + scene->objects[path->object].material;
    const TablePlace place = returned_cosine(scene, cosine);
    const float3 depths = fmax(depth, 0.0f) * path->sigma.xyz, albedo = path->albedo.xyz, g = path->anisotropy.xyz;
    return (float3)(exp_scalar(returned_log(scene, material->returned_first[0], albedo.x, g.x, depths.x, place)),
                    exp_scalar(returned_log(scene, material->returned_first[1], albedo.y, g.y, depths.y, place)),
                    exp_scalar(returned_log(scene, material->returned_first[2], albedo.z, g.z, depths.z, place)));
}

#endif
