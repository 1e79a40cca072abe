// Many rays through the BVH at once, one visit each in turn: while one waits for its next node to come from memory, the others
// compute. What a ray finds does not depend on its company.
#ifndef NACRE_GEOMETRY_STREAM_H
#define NACRE_GEOMETRY_STREAM_H

#include "geometry/traverse.h"
#include "lanes/lanes.h"

#pragma OPENCL FP_CONTRACT OFF

#ifndef STREAM_RAYS
#if LANES == 1
#define STREAM_RAYS 1
#else
#define STREAM_RAYS 32 // rays of a stream, at least LANES
#endif
#endif
#ifndef STREAM_FLIGHT
#define STREAM_FLIGHT 16 // of which this many are under way at a time
#endif
#ifndef PREFETCH_LINES
#define PREFETCH_LINES 4
#endif

// OpenCL's own prefetch() does nothing in PoCL; the builtin is clang's, for machine code alone.
#if defined(__x86_64__) || defined(__aarch64__)
#define PREFETCH_LINE(p) __builtin_prefetch(p)
#else
#define PREFETCH_LINE(p)
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

// A ray under way.
typedef struct {
    Slabs slabs;
    Shear shear;
    Hit hit;
    float t_min;
    uint current; // node or leaf to visit
    uint size;    // of its stack
    uint ray;
} Flying;

// LANES rays' place in a row, from ray `first` on, a multiple of LANES.
#define STREAM_LANES(row, first) (*(real *)((row) + (first)))
#define STREAM_LANES_UINT(row, first) (*(natural *)((row) + (first)))

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

// The first lines of a node or of a leaf's first block; asking for all keeps more misses in flight than a core can (16 %
// slower out of cache), and the processor fetches what follows by itself.
void prefetch_child(global const float *nodes, global const float *blocks, uint child) {
    global const float *p = (child & BVH_LEAF_BIT)
                                ? blocks + (size_t)(child & BVH_LEAF_FIRST_MASK) * (BVH_BLOCK_ROWS * BVH_WIDTH)
                                : nodes + (size_t)child * (BVH_NODE_ROWS * BVH_WIDTH);
    for (uint line = 0; line < PREFETCH_LINES; line++) PREFETCH_LINE(p + 16u * line);
}

bool stream_start(Flying *f, const RayStream *stream, uint i, global const float *nodes) {
    const Ray ray = stream_ray(stream, i);
    f->ray = i;
    f->t_min = ray.t_min;
    f->size = 0u;
    f->current = stream->root[i];
    f->hit.t = ray.t_max;
    f->hit.block = f->hit.slot = BVH_NO_PRIMITIVE;
    const float3 rcp = ray_reciprocal(ray.direction);
    f->shear = shear_of(ray.origin, ray.direction, rcp);
    f->slabs = slabs_of(ray.origin, rcp, tree_extent(nodes, f->current));
    return is_traceable(ray.origin, ray.direction);
}

// One visit. False: the ray has all it wants.
bool stream_visit(Flying *f, global const float *nodes, global const float *blocks, bool any, uint *stack, float *stack_t) {
    uint current = f->current;
    if (!(current & BVH_LEAF_BIT)) {
        current = enter_node(&f->slabs, nodes + (size_t)current * (BVH_NODE_ROWS * BVH_WIDTH), f->t_min, f->hit.t, stack,
                             stack_t, &f->size);
        if (current != BVH_NO_CHILD) {
            f->current = current;
            return true;
        }
    } else if (meet_leaf(&f->shear, blocks, current, f->t_min, any, &f->hit)) {
        return false;
    }
    uint size = f->size;
    do {
        if (size == 0u) return false;
        size--;
    } while (stack_t[size] > f->hit.t);
    f->size = size;
    f->current = stack[size];
    return true;
}

// Traces the rays whose bits are set in `wanted`: the closest hits, or with `any` some hit.
void trace_stream(RayStream *stream, ulong wanted, global const float *nodes, global const float *blocks, bool any) {
    Flying flying[STREAM_FLIGHT];
    uint stack[STREAM_FLIGHT][BVH_STACK];
    float stack_t[STREAM_FLIGHT][BVH_STACK];
    uint busy = 0u, idle = (1u << STREAM_FLIGHT) - 1u;
    for (;;) {
        while (idle != 0u && wanted != 0ul) {
            const uint at = lowest_bit(idle), i = lowest_bit64(wanted);
            wanted &= wanted - 1ul;
            if (stream_start(&flying[at], stream, i, nodes)) {
                idle &= idle - 1u;
                busy |= 1u << at;
                prefetch_child(nodes, blocks, flying[at].current);
            } else {
                stream->block[i] = BVH_NO_PRIMITIVE;
            }
        }
        if (busy == 0u) return;
        for (uint turn = busy; turn != 0u; turn &= turn - 1u) {
            const uint at = lowest_bit(turn);
            Flying *f = &flying[at];
            if (stream_visit(f, nodes, blocks, any, stack[at], stack_t[at])) {
                prefetch_child(nodes, blocks, f->current);
                continue;
            }
            stream->t[f->ray] = f->hit.t;
            stream->block[f->ray] = f->hit.block;
            stream->slot[f->ray] = f->hit.slot;
            busy &= ~(1u << at);
            idle |= 1u << at;
        }
    }
}

#endif
