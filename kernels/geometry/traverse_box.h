// One ray against the boxes of a node, conservatively: a box is entered if the triangle test may hit anything in it.
#ifndef NACRE_GEOMETRY_TRAVERSE_BOX_H
#define NACRE_GEOMETRY_TRAVERSE_BOX_H

#include "geometry/ray.h"
#include "geometry/traverse_row.h"

#pragma OPENCL FP_CONTRACT OFF

// t of a plane is bound * rcp + shift; u = 2^-24 is the unit roundoff. What rounds:
// - A vertex relative to the ray, in the triangle test: 5 u |v - origin|, 9 u where division is only good to 2.5 ulp.
// - origin * rcp in the shift: as if the origin moved by u |origin|.
// - rcp and the fma: 3 u, or 7 u, of t, for a near and for a far plane: as if each moved by that share of its distance.
// In sum less than 17 u (extent + |origin|). Near planes move that much (and half more) towards the origin, far ones
// away from it, which costs nothing per node. A slab test with bounds relative to t (Ize 2013) is not enough: it misses
// what the triangle test hits beside a box that is nearer than its triangles are large.
#define SLAB_SLACK 1.6e-6f

typedef struct {
    float3 rcp, near_shift, far_shift;
    uint near_x, near_y, near_z, far_x, far_y, far_z; // where the rows start in a node
} Slabs;

// Of lower and upper bounds, by the signs of rcp.
void set_slab_rows(Slabs *s) {
    s->near_x = (as_uint(s->rcp.x) >> 31) * BVH_WIDTH;
    s->near_y = (as_uint(s->rcp.y) >> 31) * BVH_WIDTH + 2u * BVH_WIDTH;
    s->near_z = (as_uint(s->rcp.z) >> 31) * BVH_WIDTH + 4u * BVH_WIDTH;
    s->far_x = s->near_x ^ BVH_WIDTH;
    s->far_y = s->near_y ^ BVH_WIDTH;
    s->far_z = s->near_z ^ BVH_WIDTH;
}

Slabs slabs_of(float3 origin, float3 rcp, float extent) {
    const float3 a = fabs(origin);
    const float3 slack = fabs(rcp) * (SLAB_SLACK * (extent + max(a.x, max(a.y, a.z))));
    Slabs s;
    s.rcp = rcp;
    s.near_shift = -origin * rcp - slack;
    s.far_shift = -origin * rcp + slack;
    set_slab_rows(&s);
    return s;
}

// Bits of the boxes, from `node` (+ slot) on, that the ray meets between t_min and t_max; *near: where it enters them.
// max and min, not fmax and fmin: these cost 6-19 %, and a NaN here ends in a false comparison or one box too many.
uint boxes_hit(const Slabs *s, global const float *node, float t_min, float t_max, Row *near) {
    const Row near_x = fma(load_row(node + s->near_x), (Row)(s->rcp.x), (Row)(s->near_shift.x));
    const Row near_y = fma(load_row(node + s->near_y), (Row)(s->rcp.y), (Row)(s->near_shift.y));
    const Row near_z = fma(load_row(node + s->near_z), (Row)(s->rcp.z), (Row)(s->near_shift.z));
    const Row far_x = fma(load_row(node + s->far_x), (Row)(s->rcp.x), (Row)(s->far_shift.x));
    const Row far_y = fma(load_row(node + s->far_y), (Row)(s->rcp.y), (Row)(s->far_shift.y));
    const Row far_z = fma(load_row(node + s->far_z), (Row)(s->rcp.z), (Row)(s->far_shift.z));
    *near = max(max(near_x, near_y), max(near_z, (Row)(t_min)));
    return row_bits(*near <= min(min(far_x, far_y), min(far_z, (Row)(t_max))));
}

#endif
