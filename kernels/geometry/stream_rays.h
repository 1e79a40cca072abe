// The rays of a stream, what they find, and what their way through the tree needs, computed for a row of rays at once.
#ifndef NACRE_GEOMETRY_STREAM_RAYS_H
#define NACRE_GEOMETRY_STREAM_RAYS_H

#include "geometry/traverse.h"
#include "lanes/lanes.h"

#pragma OPENCL FP_CONTRACT OFF

#ifndef STREAM_RAYS
#if LANES == 1
#define STREAM_RAYS 1 // a work-item is one lane, and has one ray
#else
#define STREAM_RAYS 64 // as many as there are walks in a turn
#endif
#endif
#if STREAM_RAYS > 1 && (STREAM_RAYS > 64 || STREAM_RAYS % BVH_WIDTH != 0 || STREAM_RAYS % LANES != 0)
#error "STREAM_RAYS must be a multiple of BVH_WIDTH and LANES and at most 64, the bits of a ulong"
#endif

// Rays and what they find, as rows, so that lanes can write theirs in one store. On return t is that of the hit, or t_max as
// it was; block and slot say where the triangle is, block = BVH_NO_PRIMITIVE: nowhere.
typedef struct {
    float origin_x[STREAM_RAYS] __attribute__((aligned(64))), origin_y[STREAM_RAYS], origin_z[STREAM_RAYS];
    float direction_x[STREAM_RAYS], direction_y[STREAM_RAYS], direction_z[STREAM_RAYS];
    float t_min[STREAM_RAYS], t[STREAM_RAYS];
    uint root[STREAM_RAYS];
    uint block[STREAM_RAYS], slot[STREAM_RAYS];
} RayStream;

// LANES rays' place in a row, from ray `first` on, a multiple of LANES.
#if LANES == 1
#define STREAM_LANES(row, first) ((row)[first])
#define STREAM_LANES_UINT(row, first) ((row)[first])
#else
#define STREAM_LANES(row, first) (*(real *)((row) + (first)))
#define STREAM_LANES_UINT(row, first) (*(natural *)((row) + (first)))
#endif

void stream_put(RayStream *stream, uint i, Ray ray, uint root) {
    stream->origin_x[i] = ray.origin.x;
    stream->origin_y[i] = ray.origin.y;
    stream->origin_z[i] = ray.origin.z;
    stream->direction_x[i] = ray.direction.x;
    stream->direction_y[i] = ray.direction.y;
    stream->direction_z[i] = ray.direction.z;
    stream->t_min[i] = ray.t_min;
    stream->t[i] = ray.t_max;
    stream->root[i] = root;
}

Ray stream_ray(const RayStream *stream, uint i) {
    Ray ray;
    ray.origin = (float3)(stream->origin_x[i], stream->origin_y[i], stream->origin_z[i]);
    ray.direction = (float3)(stream->direction_x[i], stream->direction_y[i], stream->direction_z[i]);
    ray.t_min = stream->t_min[i];
    ray.t_max = stream->t[i];
    return ray;
}

Hit stream_hit(const RayStream *stream, global const float *blocks, uint i) {
    Hit hit;
    hit.t = stream->t[i];
    hit.block = stream->block[i];
    hit.slot = stream->slot[i];
    hit.primitive = hit.block == BVH_NO_PRIMITIVE ? BVH_NO_PRIMITIVE : block_primitive(blocks, hit.block, hit.slot);
    return hit;
}

#if STREAM_RAYS > 1

// Slabs and shears of the rays. Ray by ray they took a third of the time of short rays.
typedef struct {
    float rcp_x[STREAM_RAYS] __attribute__((aligned(64))), rcp_y[STREAM_RAYS], rcp_z[STREAM_RAYS];
    float near_x[STREAM_RAYS], near_y[STREAM_RAYS], near_z[STREAM_RAYS];
    float far_x[STREAM_RAYS], far_y[STREAM_RAYS], far_z[STREAM_RAYS];
    float u[STREAM_RAYS], v[STREAM_RAYS], w[STREAM_RAYS]; // the origin's components along the shear's x, y, z
    float slope_u[STREAM_RAYS], slope_v[STREAM_RAYS], rcp_w[STREAM_RAYS];
    uint axis[STREAM_RAYS]; // the shear's z
} StreamSetup;

Row ray_row(const float *rows, uint i) { return *(const Row *)(rows + i); }
void set_ray_row(float *rows, uint i, Row x) { *(Row *)(rows + i) = x; }

Row row_reciprocal(Row x) {
    const Row smallest = copysign((Row)(1e-18f), x);
    return (Row)(1.0f) / select(x, smallest, fabs(x) < fabs(smallest));
}

Row row_of_extents(const RayStream *stream, uint i, ulong wanted, global const float *nodes) {
    Row extents;
    for (uint k = 0; k < ROW_SIZE; k++)
        ((float *)&extents)[k] = (wanted >> (i + k) & 1ul) ? tree_extent(nodes, stream->root[i + k]) : 0.0f;
    return extents;
}

void set_slab(float *rcps, float *nears, float *fars, uint i, Row origin, Row rcp, Row slack) {
    const Row wide = fabs(rcp) * slack;
    set_ray_row(rcps, i, rcp);
    set_ray_row(nears, i, -origin * rcp - wide);
    set_ray_row(fars, i, -origin * rcp + wide);
}

// The arithmetic of ray_reciprocal, slabs_of, shear_of and is_traceable. Returns the bits of the rays that may hit something.
ulong set_up_stream(StreamSetup *s, const RayStream *stream, ulong wanted, global const float *nodes) {
    ulong traceable = 0ul;
    for (uint i = 0; i < STREAM_RAYS; i += ROW_SIZE) {
        if ((wanted >> i & first_bits(ROW_SIZE)) == 0ul) continue;
        const Row ox = ray_row(stream->origin_x, i), dx = ray_row(stream->direction_x, i), rx = row_reciprocal(dx);
        const Row oy = ray_row(stream->origin_y, i), dy = ray_row(stream->direction_y, i), ry = row_reciprocal(dy);
        const Row oz = ray_row(stream->origin_z, i), dz = ray_row(stream->direction_z, i), rz = row_reciprocal(dz);
        const Row length = fabs(dx) + fabs(dy) + fabs(dz), away = fabs(ox) + fabs(oy) + fabs(oz);
        const RowMask good = (length > (Row)(1e-6f)) & (length < (Row)(1e6f)) & (away < (Row)(1e18f));
        traceable |= (ulong)row_bits(good) << i;

        const Row extent = row_of_extents(stream, i, wanted, nodes);
        const Row slack = (Row)(SLAB_SLACK) * (extent + max(fabs(ox), max(fabs(oy), fabs(oz))));
        set_slab(s->rcp_x, s->near_x, s->far_x, i, ox, rx, slack);
        set_slab(s->rcp_y, s->near_y, s->far_y, i, oy, ry, slack);
        set_slab(s->rcp_z, s->near_z, s->far_z, i, oz, rz, slack);

        const RowMask is_x = (fabs(dx) >= fabs(dy)) & (fabs(dx) >= fabs(dz)), is_y = fabs(dy) >= fabs(dz);
#define ALONG(x, y, z) select(select(z, y, is_y), x, is_x) // x, y or z: by the axis of the shear
        const Row rcp_w = ALONG(rx, ry, rz);
        set_ray_row(s->u, i, ALONG(oy, oz, ox));
        set_ray_row(s->v, i, ALONG(oz, ox, oy));
        set_ray_row(s->w, i, ALONG(ox, oy, oz));
        set_ray_row(s->slope_u, i, ALONG(dy, dz, dx) * rcp_w);
        set_ray_row(s->slope_v, i, ALONG(dz, dx, dy) * rcp_w);
        set_ray_row(s->rcp_w, i, rcp_w);
        *(RowBits *)(s->axis + i) = ALONG((RowBits)(0u), (RowBits)(1u), (RowBits)(2u));
#undef ALONG
    }
    return wanted & traceable;
}

Slabs slabs_in(const StreamSetup *setup, uint i) {
    Slabs s;
    s.rcp = (float3)(setup->rcp_x[i], setup->rcp_y[i], setup->rcp_z[i]);
    s.near_shift = (float3)(setup->near_x[i], setup->near_y[i], setup->near_z[i]);
    s.far_shift = (float3)(setup->far_x[i], setup->far_y[i], setup->far_z[i]);
    set_slab_rows(&s);
    return s;
}

Shear shear_in(const StreamSetup *setup, uint i) {
    Shear s;
    set_shear_axes(&s, setup->axis[i]);
    s.origin = (float3)(setup->u[i], setup->v[i], setup->w[i]);
    s.slope_x = setup->slope_u[i];
    s.slope_y = setup->slope_v[i];
    s.rcp_z = setup->rcp_w[i];
    return s;
}

#endif

#endif
