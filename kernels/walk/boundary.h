// Where a flight leaves its object. Shells inside the object (teeth, eyes) are counted, not stopped at: entering one more is
// +1, leaving one -1, and at 0 the walk is out.
#ifndef NACRE_WALK_BOUNDARY_H
#define NACRE_WALK_BOUNDARY_H

#include "geometry/surface.h"

typedef struct {
    Ray ray;        // of the last segment
    Hit hit;
    float distance; // along the flight, to where it left
    uint depth;     // shells the walk is inside of, after the flight
    uint rays;
    bool left;      // hit is where it left
} Boundary;

// Rounding of a point of this size: one or two ulp of its largest coordinate. More would cut flights short in dense media
// (2^-21: +7 % in the colour of a body 1e6 mean free paths thick), less would let walks slip through.
float position_rounding(float3 p) { return 0x1p-23f * fmax(fabs(p.x), fmax(fabs(p.y), fabs(p.z))); }

// Whether `origin` stands on the plane of a triangle that its ray enters after t, as far as rounding can tell: that of the
// origin, and that of the test, which is in proportion to the triangle (see hit_point).
bool stands_on(const Scene *scene, Hit hit, float3 normal, float cosine, float rounding) {
    const float3 v0 = triangle_vertex(scene->blocks, hit.block, hit.slot, 0u);
    const float3 size = max(fabs(triangle_vertex(scene->blocks, hit.block, hit.slot, 1u) - v0),
                            fabs(triangle_vertex(scene->blocks, hit.block, hit.slot, 2u) - v0));
    const float extent = fmax(size.x, fmax(size.y, size.z));
    return -cosine * hit.t <= (3.0f * rounding + 1e-6f * extent) * length(normal);
}

// Follows a flight of `length` from `origin` through the object whose tree is `root`. It is traced from a little before its
// start to a little beyond its end, so that neither a scatter nor the next flight is outside by rounding. An entrance into
// the surface that it stands on is none: so a walk starts on the surface itself, not below it, however dense the medium.
Boundary boundary_follow(const Scene *scene, uint root, float3 origin, float3 direction, float length, uint depth) {
    const float rounding = position_rounding(origin);
    Boundary boundary;
    boundary.ray.origin = origin - rounding * direction;
    boundary.ray.direction = direction;
    boundary.ray.t_min = 0.0f;
    boundary.ray.t_max = length + 2.0f * rounding;
    boundary.depth = depth;
    boundary.rays = 0u;
    boundary.left = false;
    for (;;) {
        boundary.hit = trace_closest(boundary.ray, scene->nodes, scene->blocks, root);
        boundary.rays += 1u;
        if (boundary.hit.primitive == BVH_NO_PRIMITIVE) return boundary;
        const float3 normal = hit_normal(scene, boundary.hit);
        const float cosine = dot(normal, direction);
        if (cosine < 0.0f) {
            if (!stands_on(scene, boundary.hit, normal, cosine, rounding)) boundary.depth += 1u;
        } else {
            boundary.depth -= 1u;
            if (boundary.depth == 0u) {
                boundary.left = true;
                boundary.distance = fmax(0.0f, boundary.hit.t - rounding);
                return boundary;
            }
        }
        boundary.ray.t_min = boundary.hit.t;
    }
}

#endif
