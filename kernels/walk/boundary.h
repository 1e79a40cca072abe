// Where a flight leaves its object. Shells inside the object (teeth, eyes) are counted, not stopped at: entering one more is
// +1, leaving one -1, and at 0 the walk is out.
#ifndef NACRE_WALK_BOUNDARY_H
#define NACRE_WALK_BOUNDARY_H

#include "geometry/surface.h"

// Counts a hit of a flight (MEET_FLIGHT) along `direction`. True where the flight leaves its object there.
bool boundary_leaves(const Scene *scene, Hit hit, float3 direction, uint *depth) {
    if (dot(hit_normal(scene, hit), direction) < 0.0f) {
        *depth += 1u;
        return false;
    }
    *depth -= 1u;
    return *depth == 0u;
}

#endif
