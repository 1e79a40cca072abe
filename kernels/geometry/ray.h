// Rays, hits, and what follows from a hit: vertices, barycentrics, position with its rounding error, the way off.
#ifndef NACRE_GEOMETRY_RAY_H
#define NACRE_GEOMETRY_RAY_H

#include "lanes/scalar.h"
#include "shared/bvh.h"

#pragma OPENCL FP_CONTRACT OFF

#ifndef BVH_WIDTH
#define BVH_WIDTH 8
#endif

// A hit has t_min < t <= t_max, t in lengths of `direction` (of about unit length). 0 <= t_min; t_max may be infinite.
typedef struct {
    float3 origin, direction;
    float t_min, t_max;
} Ray;

Ray path_ray(float3 position, float3 direction) {
    Ray ray;
    ray.origin = position;
    ray.direction = direction;
    ray.t_min = 0.0f;
    ray.t_max = MAXFLOAT;
    return ray;
}

// The triangle lies in `slot` of leaf block `block`. A miss has primitive = BVH_NO_PRIMITIVE and t = the ray's t_max.
typedef struct {
    float t;
    uint block, slot;
    uint primitive;
} Hit;

// 1 / direction, finite: a component below 1e-18 moves the ray less than rounding does over any distance in a scene.
float3 ray_reciprocal(float3 direction) {
    const float3 smallest = copysign((float3)(1e-18f), direction);
    return 1.0f / select(direction, smallest, fabs(direction) < fabs(smallest));
}

// A ray seen along its longest axis z, after Woop, Benthin, Wald 2013, "Watertight Ray/Triangle Intersection": x, y, z
// are a rotation of the axes; less `origin` and less z times the slopes, points of the ray have x = y = 0.
typedef struct {
    uint x, y, z;  // which axis is which
    float3 origin; // in that order
    float slope_x, slope_y;
    float rcp_z; // distance along z -> t
} Shear;

float3 rotated(float3 v, uint z) { return z == 0u ? v.yzx : z == 1u ? v.zxy : v; }

void set_shear_axes(Shear *s, uint z) {
    s->z = z;
    s->x = z == 2u ? 0u : z + 1u;
    s->y = z == 0u ? 2u : z - 1u;
}

Shear shear_of(float3 origin, float3 direction, float3 rcp) {
    const float3 a = fabs(direction);
    Shear s;
    set_shear_axes(&s, a.x >= a.y ? (a.x >= a.z ? 0u : 2u) : (a.y >= a.z ? 1u : 2u));
    s.origin = rotated(origin, s.z);
    s.rcp_z = rotated(rcp, s.z).z;
    const float3 slopes = rotated(direction, s.z) * s.rcp_z;
    s.slope_x = slopes.x;
    s.slope_y = slopes.y;
    return s;
}

// Rounding of a point of this size, as a share of its largest coordinate: one or two ulp. More would cut flights short in
// dense media (2^-21: +7 % in the colour of a body 1e6 mean free paths thick), less would let walks slip through.
#define POSITION_ROUNDING 0x1p-23f

// Vertex k (0..2) of a triangle.
float3 triangle_vertex(global const float *blocks, uint block, uint slot, uint k) {
    global const float *rows = blocks + ((size_t)block * BVH_BLOCK_ROWS + 3u * k) * BVH_WIDTH + slot;
    return (float3)(rows[0], rows[BVH_WIDTH], rows[2 * BVH_WIDTH]);
}

// On the counter-clockwise side of a triangle with edges e1 and e2 from one vertex, 2^41 times its area long: the square of the
// length is a normal number for edges from 1e-16 on.
float3 triangle_normal(float3 e1, float3 e2) { return cross(e1, e2) * 0x1p40f; }

uint block_primitive(global const float *blocks, uint block, uint slot) {
    return as_uint(blocks[((size_t)block * BVH_BLOCK_ROWS + BVH_ROW_PRIMITIVE) * BVH_WIDTH + slot]);
}

// A vertex seen along the ray. With the arithmetic of sheared_vertex, so that what follows from it agrees with what was hit.
float3 sheared(const Shear *s, float3 v) {
    const float3 at = rotated(v, s->z) - s->origin;
    return (float3)(fma(-s->slope_x, at.z, at.x), fma(-s->slope_y, at.z, at.y), at.z);
}

// Weights of the three vertices at a hit: each >= 0, sum 1 up to rounding. The arithmetic of traverse_triangle.h.
float3 hit_barycentrics(Ray ray, global const float *blocks, Hit hit) {
    const Shear s = shear_of(ray.origin, ray.direction, ray_reciprocal(ray.direction));
    const float3 a = sheared(&s, triangle_vertex(blocks, hit.block, hit.slot, 0u));
    const float3 b = sheared(&s, triangle_vertex(blocks, hit.block, hit.slot, 1u));
    const float3 c = sheared(&s, triangle_vertex(blocks, hit.block, hit.slot, 2u));
    const float3 w = (float3)(c.x * b.y - c.y * b.x, a.x * c.y - a.y * c.x, b.x * a.y - b.y * a.x);
    return w / (w.x + w.y + w.z);
}

// The point with weights w on the hit triangle, which rounds far less than origin + t * direction. `error` bounds, per
// component, two roundings: of this sum (gamma_7 of the absolute sum: Pharr, Jakob, Humphreys, "Physically Based
// Rendering", 3rd ed., section 3.9.4), and of a ray that starts here and is tested against this same triangle, whose
// vertices relative to the ray round in proportion to its extent (by up to 10 u, u = 2^-24; 16 u are taken).
float3 hit_point(global const float *blocks, Hit hit, float3 w, float3 *error) {
    const float3 v0 = triangle_vertex(blocks, hit.block, hit.slot, 0u);
    const float3 v1 = triangle_vertex(blocks, hit.block, hit.slot, 1u);
    const float3 v2 = triangle_vertex(blocks, hit.block, hit.slot, 2u);
    const float3 size = max(fabs(v1 - v0), fabs(v2 - v0));
    const float extent = max(size.x, max(size.y, size.z));
    *error = 4.18e-7f * (fabs(w.x * v0) + fabs(w.y * v1) + fabs(w.z * v2)) + 9.6e-7f * extent;
    return w.x * v0 + w.y * v1 + w.z * v2;
}

// The next floats to the side of `offset`; where that is 0 (or x is) x itself. nextafter() took 2 % of a walk.
float3 next_towards(float3 x, float3 offset) {
    const int3 outwards = as_int3(offset) ^ as_int3(x); // >= 0: away from 0
    const int3 next = as_int3(x) + select((int3)(-1), (int3)(1), outwards >= 0);
    return select(x, as_float3(next), (offset != 0.0f) & (x != 0.0f));
}

// Moves p off its triangle, to the side that `direction` points to, as far as its error asks for: a ray from there
// cannot meet the triangle again. `ng` is the unit geometric normal, on either side. Section 3.9.5 of the same book.
float3 offset_point(float3 p, float3 error, float3 ng, float3 direction) {
    const float distance = dot(fabs(ng), error);
    const float3 offset = dot(ng, direction) < 0.0f ? -distance * ng : distance * ng;
    const float3 moved = p + offset;
    return next_towards(moved, offset);
}

#endif
