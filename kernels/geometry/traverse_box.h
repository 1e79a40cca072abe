// One ray against the boxes of a node, conservatively: a box that holds any point which the triangle test may call hit is
// entered.
#ifndef NACRE_GEOMETRY_TRAVERSE_BOX_H
#define NACRE_GEOMETRY_TRAVERSE_BOX_H

#include "geometry/ray.h"
#include "geometry/traverse_row.h"

#pragma OPENCL FP_CONTRACT OFF

// t of a plane is bound * rcp + shift. u = 2^-24 is the unit roundoff.
// - The triangle test rounds a vertex v, relative to the ray, by up to 4 u (|v - origin| + |v_z - origin_z|) (8 u where division
//   is only good to 2.5 ulp); rounding origin * rcp in `shift` is as if the origin moved by u |origin|. All that is bounded
//   by 16 u (extent + |origin|), by which near planes move towards the ray and far ones away.
// - What is left is relative to t: 5 u of the reciprocal and u of the sum, for each of two planes: far ones get 16 u more.
#define SLAB_SHIFT 9.6e-7f
#define SLAB_SCALE 1.00000096f

typedef struct {
    float3 near_rcp, near_shift, far_rcp, far_shift;
    uint near_x, near_y, near_z, far_x, far_y, far_z; // where the rows start in a node
} Slabs;

// A direction component this small moves the ray by less than float's spacing over any distance in the scene; its slab is
// decided by the origin alone, without 0 * infinity.
#define SLAB_SMALLEST 1e-18f

float slab_rcp(float d) { return 1.0f / (fabs(d) < SLAB_SMALLEST ? copysign(SLAB_SMALLEST, d) : d); }

Slabs slabs_of(Ray ray, float extent) {
    const float3 o = ray.origin, a = fabs(o);
    const float3 rcp = (float3)(slab_rcp(ray.direction.x), slab_rcp(ray.direction.y), slab_rcp(ray.direction.z));
    const float3 slack = copysign((float3)(SLAB_SHIFT * (extent + max(a.x, max(a.y, a.z)))), rcp);
    Slabs s;
    s.near_rcp = rcp;
    s.far_rcp = rcp * SLAB_SCALE;
    s.near_shift = -(o + slack) * s.near_rcp;
    s.far_shift = -(o - slack) * s.far_rcp;
    s.near_x = rcp.x < 0.0f ? 1u * BVH_WIDTH : 0u;
    s.near_y = rcp.y < 0.0f ? 3u * BVH_WIDTH : 2u * BVH_WIDTH;
    s.near_z = rcp.z < 0.0f ? 5u * BVH_WIDTH : 4u * BVH_WIDTH;
    s.far_x = s.near_x ^ BVH_WIDTH;
    s.far_y = s.near_y ^ BVH_WIDTH;
    s.far_z = s.near_z ^ BVH_WIDTH;
    return s;
}

// Bits of the boxes, from `node` (+ slot) on, that the ray meets between t_min and t_max; *near: where it enters them.
// max and min, not fmax and fmin: these cost 6-19 % for NaN, and a NaN here ends in a false comparison or one box too many.
uint boxes_hit(const Slabs *s, global const float *node, float t_min, float t_max, Row *near) {
    const Row near_x = fma(load_row(node + s->near_x), (Row)(s->near_rcp.x), (Row)(s->near_shift.x));
    const Row near_y = fma(load_row(node + s->near_y), (Row)(s->near_rcp.y), (Row)(s->near_shift.y));
    const Row near_z = fma(load_row(node + s->near_z), (Row)(s->near_rcp.z), (Row)(s->near_shift.z));
    const Row far_x = fma(load_row(node + s->far_x), (Row)(s->far_rcp.x), (Row)(s->far_shift.x));
    const Row far_y = fma(load_row(node + s->far_y), (Row)(s->far_rcp.y), (Row)(s->far_shift.y));
    const Row far_z = fma(load_row(node + s->far_z), (Row)(s->far_rcp.z), (Row)(s->far_shift.z));
    *near = max(max(near_x, near_y), max(near_z, (Row)(t_min)));
    return row_bits(*near <= min(min(far_x, far_y), min(far_z, (Row)(t_max * SLAB_SCALE))));
}

#endif
