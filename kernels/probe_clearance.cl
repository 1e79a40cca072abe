// Looks clearances up as a walk does, for the tests and benchmarks of walk/clearance.h.
#include "walk/clearance.h"

#ifndef WORK_GROUP
#define WORK_GROUP 1
#endif

// points: x, y, z, and the index of a field (uint bits); `count` is a multiple of LANES, and a work-item takes LANES of
// them. bounds: one number each.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void
probe_clearance(global const float4 *points, global const Clearance *fields, global const uint *bricks,
                global float *bounds, uint count) {
    const uint begin = get_global_id(0) * LANES;
    if (begin >= count) return;
    ClearanceLanes lanes;
    real x, y, z;
    for (uint lane = 0; lane < LANES; lane++) {
        const float4 point = points[begin + lane];
        LANE_FLOAT(x, lane) = point.x;
        LANE_FLOAT(y, lane) = point.y;
        LANE_FLOAT(z, lane) = point.z;
        clearance_set(&lanes, lane, fields + as_uint(point.w));
    }
    const real bound = clearance_at(bricks, &lanes, x, y, z);
    for (uint lane = 0; lane < LANES; lane++) bounds[begin + lane] = LANE_FLOAT(bound, lane);
}
