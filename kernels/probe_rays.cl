// Entry points that trace given rays, for the tests and benchmarks of geometry/.
#include "geometry/ray.h"
#include "geometry/stream.h"

#ifndef RAYS_PER_ITEM
#define RAYS_PER_ITEM 1
#endif
#ifndef WORK_GROUP
#define WORK_GROUP 1
#endif

// rays: origin and t_max, direction and t_min.
Ray load_ray(global const float4 *rays, uint index) {
    const float4 a = rays[2u * index], b = rays[2u * index + 1u];
    Ray ray;
    ray.origin = a.xyz;
    ray.t_max = a.w;
    ray.direction = b.xyz;
    ray.t_min = b.w;
    return ray;
}

// Fills a stream with the rays from `begin` on, up to `end`; how many.
uint load_stream(RayStream *stream, global const float4 *rays, uint begin, uint end, uint root) {
    const uint count = min((uint)STREAM_RAYS, end - begin);
    for (uint i = 0; i < count; i++) stream_put(stream, i, load_ray(rays, begin + i), root);
    return count;
}

// hits: t, primitive, block, slot.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void
probe_closest(global const float4 *rays, global uint4 *hits, global const float *nodes, global const float *blocks,
              uint root, uint count) {
    const uint begin = get_global_id(0) * RAYS_PER_ITEM, end = min(begin + RAYS_PER_ITEM, count);
    RayStream stream;
    for (uint i = begin; i < end; i += STREAM_RAYS) {
        const uint part = load_stream(&stream, rays, i, end, root);
        trace_stream(&stream, first_bits(part), nodes, blocks, MEET_CLOSEST);
        for (uint k = 0; k < part; k++) {
            const Hit hit = stream_hit(&stream, blocks, k);
            hits[i + k] = (uint4)(as_uint(hit.t), hit.primitive, hit.block, hit.slot);
        }
    }
}

// hits: 1 where something is in the way.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void
probe_any(global const float4 *rays, global uint *hits, global const float *nodes, global const float *blocks,
          uint root, uint count) {
    const uint begin = get_global_id(0) * RAYS_PER_ITEM, end = min(begin + RAYS_PER_ITEM, count);
    RayStream stream;
    for (uint i = begin; i < end; i += STREAM_RAYS) {
        const uint part = load_stream(&stream, rays, i, end, root);
        trace_stream(&stream, first_bits(part), nodes, blocks, MEET_ANY);
        for (uint k = 0; k < part; k++) hits[i + k] = stream.block[k] != BVH_NO_PRIMITIVE;
    }
}

// Traces a ray and, from where it hits, another one along `directions` (3 floats each), off the surface on the side that
// it points to. bounces: both primitives, t of the second, its cosine with the first's counter-clockwise normal.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void
probe_bounce(global const float4 *rays, global uint4 *bounces, global const float *nodes, global const float *blocks,
             uint root, uint count, global const float *directions) {
    const uint begin = get_global_id(0) * RAYS_PER_ITEM;
    for (uint i = begin; i < min(begin + RAYS_PER_ITEM, count); i++) {
        Ray ray = load_ray(rays, i);
        const Hit hit = trace_closest(ray, nodes, blocks, root);
        bounces[i] = (uint4)(hit.primitive, BVH_NO_PRIMITIVE, 0u, 0u);
        if (hit.primitive == BVH_NO_PRIMITIVE) continue;

        float3 error;
        const float3 p = hit_point(blocks, hit, hit_barycentrics(ray, blocks, hit), &error);
        const float3 v0 = triangle_vertex(blocks, hit.block, hit.slot, 0u);
        const float3 ng = unit3(triangle_normal(triangle_vertex(blocks, hit.block, hit.slot, 1u) - v0,
                                                triangle_vertex(blocks, hit.block, hit.slot, 2u) - v0));
        ray.direction = vload3(i, directions);
        ray.origin = offset_point(p, error, ng, ray.direction);
        ray.t_min = 0.0f;
        ray.t_max = MAXFLOAT;
        const Hit next = trace_closest(ray, nodes, blocks, root);
        bounces[i] = (uint4)(hit.primitive, next.primitive, as_uint(next.t), as_uint(dot(ng, ray.direction)));
    }
}
