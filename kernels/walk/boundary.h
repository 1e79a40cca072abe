// Where a flight leaves its object. Shells inside the object (teeth, eyes) are counted, not stopped at: entering one more is
// +1, leaving one -1, and at 0 the walk is out.
#ifndef NACRE_WALK_BOUNDARY_H
#define NACRE_WALK_BOUNDARY_H

#include "geometry/surface.h"

typedef struct {
    Hit hit;
    uint depth; // shells the walk is inside of, after the flight
    uint rays;
    bool left;  // hit is where it left
} Boundary;

// Rounding of a point of this size: a few ulp of its largest coordinate.
float position_rounding(float3 p) { return 0x1p-21f * fmax(fabs(p.x), fmax(fabs(p.y), fabs(p.z))); }

// Follows a flight of `length` from `origin` through the object whose tree is `root`. A segment is traced a little beyond
// its end, so that no scatter lands outside by rounding; an entrance right at its start is the surface it stands on.
Boundary boundary_follow(const Scene *scene, uint root, float3 origin, float3 direction, float length, uint depth) {
    const float rounding = position_rounding(origin);
    Ray ray;
    ray.origin = origin;
    ray.direction = direction;
    ray.t_min = 0.0f;
    ray.t_max = length + rounding;
    Boundary boundary;
    boundary.depth = depth;
    boundary.rays = 0u;
    boundary.left = false;
    for (;;) {
        boundary.hit = trace_closest(ray, scene->nodes, scene->blocks, root);
        boundary.rays += 1u;
        if (boundary.hit.primitive == BVH_NO_PRIMITIVE) return boundary;
        if (dot(hit_normal(scene, boundary.hit), direction) < 0.0f) {
            if (boundary.hit.t > 2.0f * rounding) boundary.depth += 1u;
        } else {
            boundary.depth -= 1u;
            if (boundary.depth == 0u) {
                boundary.left = true;
                return boundary;
            }
        }
        ray.t_min = boundary.hit.t;
    }
}

#endif
