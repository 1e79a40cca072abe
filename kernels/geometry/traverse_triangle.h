// One ray against the triangles of a leaf block, without gaps between neighbours: Woop, Benthin, Wald 2013.
#ifndef NACRE_GEOMETRY_TRAVERSE_TRIANGLE_H
#define NACRE_GEOMETRY_TRAVERSE_TRIANGLE_H

#include "geometry/ray.h"
#include "geometry/traverse_row.h"

#pragma OPENCL FP_CONTRACT OFF

// A vertex relative to the ray. It depends on nothing but vertex and ray: neighbours see the same one.
typedef struct {
    Row x, y, z;
} RowVertex;

RowVertex sheared_vertex(const Shear *s, global const float *rows) {
    RowVertex v;
    v.z = load_row(rows + s->z * BVH_WIDTH) - (Row)(s->origin.z);
    v.x = fma((Row)(-s->slope_x), v.z, load_row(rows + s->x * BVH_WIDTH) - (Row)(s->origin.x));
    v.y = fma((Row)(-s->slope_y), v.z, load_row(rows + s->y * BVH_WIDTH) - (Row)(s->origin.y));
    return v;
}

// Twice the signed area of (0, a, b). Never with fma: both products round alike, so that the sign is right or the value
// is 0, and the edge seen from the neighbour, b to a, is exactly the negative.
Row edge_function(RowVertex a, RowVertex b) { return a.x * b.y - a.y * b.x; }

// Bits of the triangles, from `block` (+ slot) on, that the ray meets with t_min < t <= t_max; t = *distance / *area.
// Points on edges belong to both triangles, triangles without area to none.
uint triangles_hit(const Shear *s, global const float *block, float t_min, float t_max, Row *distance, Row *area) {
    const RowVertex a = sheared_vertex(s, block);
    const RowVertex b = sheared_vertex(s, block + 3 * BVH_WIDTH);
    const RowVertex c = sheared_vertex(s, block + 6 * BVH_WIDTH);
    const Row u = edge_function(c, b), v = edge_function(a, c), w = edge_function(b, a);
    const Row twice_area = u + v + w;
    const Row z = fma(u, a.z, fma(v, b.z, w * c.z)) * (Row)(s->rcp_z);

    // Both sides of a triangle are hit: turn all signs round where the area is negative.
    const RowBits sign = as_row_bits(twice_area) & 0x80000000u;
    const Row inside = min(min(as_row(as_row_bits(u) ^ sign), as_row(as_row_bits(v) ^ sign)),
                           as_row(as_row_bits(w) ^ sign));
    *area = as_row(as_row_bits(twice_area) ^ sign);
    *distance = as_row(as_row_bits(z) ^ sign);
    return row_bits((inside >= (Row)(0.0f)) & (*area > (Row)(0.0f)) & (*distance > *area * (Row)(t_min)) &
                    (*distance <= *area * (Row)(t_max)));
}

#endif
