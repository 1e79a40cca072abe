// Computes with the functions of exact/builtins.h and lanes/scalar.h, for their test. Compile with EXACT.
#include "exact/builtins.h"
#include "lanes/scalar.h"

#ifndef WORK_GROUP
#define WORK_GROUP 1
#endif

// vectors: two per work-item. results: seven numbers each, see tests/device/exact.cpp.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void probe_exact(global const float4 *vectors,
                                                                                global float *results) {
    const uint i = get_global_id(0);
    const float3 a = vectors[2u * i].xyz, b = vectors[2u * i + 1u].xyz, unit = unit3(a), c = cross(a, b);
    global float *result = results + 7u * i;
    result[0] = dot(a, b);
    result[1] = length3(a);
    result[2] = dot(unit, unit);
    result[3] = dot(c, c);
    result[4] = atan2_scalar(a.y, a.x);
    result[5] = unit.x;
    result[6] = mix(a.x, b.x, vectors[2u * i].w);
}
