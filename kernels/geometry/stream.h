// Many rays through the BVH at once, one visit each in turn: while one waits for its next node to come from memory, the others
// compute. What a ray finds does not depend on its company.
#ifndef NACRE_GEOMETRY_STREAM_H
#define NACRE_GEOMETRY_STREAM_H

#include "geometry/stream_rays.h"

#pragma OPENCL FP_CONTRACT OFF

#if STREAM_RAYS == 1

void trace_stream(RayStream *stream, ulong wanted, global const float *nodes, global const float *blocks, bool any
                  PROFILED(, uint *visits)) {
    if (wanted == 0ul) return;
    const Ray ray = stream_ray(stream, 0u);
    const Hit hit = traverse(ray.origin, ray.direction, ray.t_min, ray.t_max, nodes, blocks, stream->root[0],
                             any PROFILED(, visits));
    stream->t[0] = hit.t;
    stream->block[0] = hit.block;
    stream->slot[0] = hit.slot;
}

#else

// OpenCL's own prefetch() does nothing in PoCL; the builtin is clang's, for machine code alone.
#if defined(__x86_64__) || defined(__aarch64__)
#define PREFETCH_LINE(p) __builtin_prefetch(p)
#else
#define PREFETCH_LINE(p)
#endif

// Where a ray is.
typedef struct {
    uint current; // node or leaf to visit
    uint size;    // of its stack
} Flying;

// The lines of a node, or of the vertices of a leaf's first block: as many for both, as a branch would cost more.
ALWAYS_INLINE void prefetch_child(global const float *nodes, global const float *blocks, uint child) {
    global const float *p = (child & BVH_LEAF_BIT)
                                ? blocks + (size_t)(child & BVH_LEAF_FIRST_MASK) * (BVH_BLOCK_ROWS * BVH_WIDTH)
                                : nodes + (size_t)child * (BVH_NODE_ROWS * BVH_WIDTH);
#pragma unroll
    for (uint at = 0; at < 9u * BVH_WIDTH; at += 16u) PREFETCH_LINE(p + at);
}

// One visit of ray i. False: it has all it wants.
ALWAYS_INLINE bool stream_visit(Flying *f, RayStream *stream, const StreamSetup *setup, uint i, global const float *nodes,
                                global const float *blocks, bool any, uint *stack, float *stack_t PROFILED(, uint *visits)) {
    uint current = f->current;
    if (!(current & BVH_LEAF_BIT)) {
        PROFILED(visits[0]++;)
        const Slabs slabs = slabs_in(setup, i);
        current = enter_node(&slabs, nodes + (size_t)current * (BVH_NODE_ROWS * BVH_WIDTH), stream->t_min[i], stream->t[i],
                             stack, stack_t, &f->size);
        if (current != BVH_NO_CHILD) {
            f->current = current;
            return true;
        }
    } else {
        PROFILED(visits[1] += leaf_blocks(current);)
        const Shear shear = shear_in(setup, i);
        Hit hit;
        hit.t = stream->t[i];
        hit.block = stream->block[i];
        hit.slot = stream->slot[i];
        const bool done = meet_leaf(&shear, blocks, current, stream->t_min[i], any, &hit);
        stream->t[i] = hit.t;
        stream->block[i] = hit.block;
        stream->slot[i] = hit.slot;
        if (done) return false;
    }
    const float t = stream->t[i];
    uint size = f->size;
    do {
        if (size == 0u) return false;
        size--;
    } while (stack_t[size] > t);
    f->size = size;
    f->current = stack[size];
    return true;
}

// Traces the rays whose bits are set in `wanted`: the closest hits, or with `any` some hit. All are under way at once:
// starting a ray whenever one ends, so that as many stay under way, cost 10 %. 16 rays at once are 2 % slower than 32, 64
// no faster.
void trace_stream(RayStream *stream, ulong wanted, global const float *nodes, global const float *blocks, bool any
                  PROFILED(, uint *visits)) {
    StreamSetup setup;
    Flying flying[STREAM_RAYS];
    uint stack[STREAM_RAYS][BVH_STACK];
    float stack_t[STREAM_RAYS][BVH_STACK];
    for (ulong turn = wanted; turn != 0ul; turn &= turn - 1ul) {
        const uint i = lowest_bit64(turn);
        stream->block[i] = stream->slot[i] = BVH_NO_PRIMITIVE;
        flying[i].current = stream->root[i];
        flying[i].size = 0u;
    }
    for (ulong busy = set_up_stream(&setup, stream, wanted, nodes); busy != 0ul;)
        for (ulong turn = busy; turn != 0ul; turn &= turn - 1ul) {
            const uint i = lowest_bit64(turn);
            if (stream_visit(&flying[i], stream, &setup, i, nodes, blocks, any, stack[i], stack_t[i]
                             PROFILED(, visits)))
                prefetch_child(nodes, blocks, flying[i].current);
            else
                busy &= ~(1ul << i);
        }
}

#endif

#endif
