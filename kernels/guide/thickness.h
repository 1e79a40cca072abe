// How thick an object is below a triangle, straight down from its centre: to guide walks it need not be known better, and a ray
// for each walk took a twentieth of a render's time.
#ifndef NACRE_GUIDE_THICKNESS_H
#define NACRE_GUIDE_THICKNESS_H

#include "geometry/traverse.h"
#include "shared/guide.h"

float thickness_below(global const float *nodes, global const float *blocks, uint root, uint block, uint slot) {
    const float3 a = triangle_vertex(blocks, block, slot, 0), b = triangle_vertex(blocks, block, slot, 1),
                 c = triangle_vertex(blocks, block, slot, 2);
    Ray ray;
    ray.origin = (a + b + c) * (1.0f / 3.0f);
    ray.direction = -unit3(triangle_normal(b - a, c - a)); // no number for a triangle without area: that ray hits nothing
    ray.t_min = GUIDE_PROBE_START;
    ray.t_max = MAXFLOAT;
    PROFILED(uint visits[2]; visits[0] = visits[1] = 0u;) // nobody's rays
    const Hit hit = trace_closest(ray, nodes, blocks, root AND_PROFILED(visits));
    return hit.block == BVH_NO_PRIMITIVE ? GUIDE_THICK : hit.t;
}

#endif
