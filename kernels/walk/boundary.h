// Where a flight leaves its object. Shells inside the object (teeth, eyes) are counted, not stopped at: entering one more is
// +1, leaving one -1, and at 0 the walk is out.
#ifndef NACRE_WALK_BOUNDARY_H
#define NACRE_WALK_BOUNDARY_H

#include "geometry/surface.h"

// Rounding of a point of this size, as a share of its largest coordinate: one or two ulp. More would cut flights short in
// dense media (2^-21: +7 % in the colour of a body 1e6 mean free paths thick), less would let walks slip through.
#define POSITION_ROUNDING 0x1p-23f

// Whether a ray's origin stands on the plane of a triangle that it enters after t, as far as rounding can tell: that of the
// origin, and that of the test, which is in proportion to the triangle (see hit_point).
bool stands_on(const Scene *scene, Hit hit, float3 normal, float cosine, float rounding) {
    const float3 v0 = triangle_vertex(scene->blocks, hit.block, hit.slot, 0u);
    const float3 size = max(fabs(triangle_vertex(scene->blocks, hit.block, hit.slot, 1u) - v0),
                            fabs(triangle_vertex(scene->blocks, hit.block, hit.slot, 2u) - v0));
    const float extent = fmax(size.x, fmax(size.y, size.z));
    return -cosine * hit.t <= (3.0f * rounding + 1e-6f * extent) * length(normal);
}

// Counts a hit of a flight along `direction`. True where the flight leaves its object there. An entrance into the surface that
// the flight stands on is none: so a walk starts on the surface itself, not below it, however dense the medium.
bool boundary_leaves(const Scene *scene, Hit hit, float3 direction, float rounding, uint *depth) {
    const float3 normal = hit_normal(scene, hit);
    const float cosine = dot(normal, direction);
    if (cosine < 0.0f) {
        if (!stands_on(scene, hit, normal, cosine, rounding)) *depth += 1u;
        return false;
    }
    *depth -= 1u;
    return *depth == 0u;
}

#endif
