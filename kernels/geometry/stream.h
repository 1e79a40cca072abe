// Many rays through the BVH at once, in rounds: a visit of each. While one waits for its next node to come from memory, the
// others compute. What a ray finds does not depend on its company.
#ifndef NACRE_GEOMETRY_STREAM_H
#define NACRE_GEOMETRY_STREAM_H

#include "geometry/stream_rays.h"

#pragma OPENCL FP_CONTRACT OFF

#if STREAM_RAYS == 1 || ROW_SIZE < BVH_WIDTH

void trace_stream(RayStream *stream, ulong wanted, global const float *nodes, global const float *blocks, int meet
                  AND_PROFILED(uint *visits)) {
    for (ulong rest = wanted; rest != 0ul; rest &= rest - 1ul) {
        const uint i = STREAM_RAYS == 1 ? 0u : lowest_bit64(rest);
        const Ray ray = stream_ray(stream, i);
        const Hit hit = traverse(ray.origin, ray.direction, ray.t_min, ray.t_max, nodes, blocks, stream->root[i],
                                 meet AND_PROFILED(visits));
        stream->t[i] = hit.t;
        stream->block[i] = hit.block;
        stream->slot[i] = hit.slot;
    }
}

#else

// OpenCL's own prefetch() does nothing in PoCL; the builtin is clang's, for machine code alone. Into the second cache: what 64
// rays wait for would push everything else out of the first. That took up to 13 % of a walk's time in large meshes.
#if defined(__x86_64__) || defined(__aarch64__)
#define PREFETCH_LINE(p) __builtin_prefetch(p, 0, 2)
#else
#define PREFETCH_LINE(p)
#endif

// Where rays are, and what they left for later.
typedef struct {
    uint current[STREAM_RAYS]; // node to visit, or leaf without the blocks that were visited
    uint at_node[STREAM_RAYS], at_leaf[STREAM_RAYS]; // rays that visit a node, or a block of a leaf, in the next round
    uint size[STREAM_RAYS];    // of the stack
    uint stack[STREAM_RAYS][BVH_STACK];
    float stack_t[STREAM_RAYS][BVH_STACK];
} Flying;

// How many rays at_node and at_leaf hold. Apart from them, so that it stays in registers.
typedef struct {
    uint nodes, leaves;
} Flock;

// The lines of a node, or of the vertices of a leaf's first block: as many for both, as a branch would cost more.
ALWAYS_INLINE void prefetch_child(global const float *nodes, global const float *blocks, uint child) {
    global const float *p = (child & BVH_LEAF_BIT)
                                ? blocks + (size_t)(child & BVH_LEAF_FIRST_MASK) * (BVH_BLOCK_ROWS * BVH_WIDTH)
                                : nodes + (size_t)child * (BVH_NODE_ROWS * BVH_WIDTH);
#pragma unroll
    for (uint at = 0; at < 9u * BVH_WIDTH; at += 16u) PREFETCH_LINE(p + at);
}

// Ray i goes to `next`. Both lists get it and one forgets it: a branch would be mispredicted every other time.
ALWAYS_INLINE void fly_to(Flying *f, Flock *flock, uint i, uint next, global const float *nodes, global const float *blocks) {
    const uint is_leaf = (next & BVH_LEAF_BIT) != 0u ? 1u : 0u;
    f->current[i] = next;
    f->at_leaf[flock->leaves] = i;
    f->at_node[flock->nodes] = i;
    flock->leaves += is_leaf;
    flock->nodes += 1u - is_leaf;
    prefetch_child(nodes, blocks, next);
}

// Ray i goes to what it left on its stack, unless nothing there is nearer than its hit at t.
ALWAYS_INLINE void fly_back(Flying *f, Flock *flock, uint i, float t, global const float *nodes, global const float *blocks) {
    uint size = f->size[i];
    do {
        if (size == 0u) return;
        size--;
    } while (f->stack_t[i][size] > t);
    f->size[i] = size;
    fly_to(f, flock, i, f->stack[i][size], nodes, blocks);
}

// One node for each ray in at_node. First all boxes, then where to go: a mispredicted branch between two rays' boxes would
// make the second's wait for the first's.
ALWAYS_INLINE void visit_nodes(Flying *f, Flock *flock, const RayStream *stream, const StreamSetup *setup,
                               global const float *nodes, global const float *blocks) {
    uint ray[STREAM_RAYS], entered[STREAM_RAYS];
    Row near[STREAM_RAYS];
    const uint count = flock->nodes;
    for (uint n = 0u; n < count; n++) {
        const uint i = ray[n] = f->at_node[n];
        const Slabs slabs = slabs_in(setup, i);
        entered[n] = boxes_hit(&slabs, nodes + (size_t)f->current[i] * (BVH_NODE_ROWS * BVH_WIDTH), stream->t_min[i],
                               stream->t[i], &near[n]);
    }
    flock->nodes = 0u;
    for (uint n = 0u; n < count; n++) {
        const uint i = ray[n];
        if (entered[n] == 0u) {
            fly_back(f, flock, i, stream->t[i], nodes, blocks);
            continue;
        }
        global const float *node = nodes + (size_t)f->current[i] * (BVH_NODE_ROWS * BVH_WIDTH);
        uint first = BVH_NO_CHILD, size = f->size[i];
        float first_t = 0.0f;
        enter_children((global const uint *)(node + BVH_ROW_CHILD * BVH_WIDTH), (const float *)&near[n], entered[n], &first,
                       &first_t, f->stack[i], f->stack_t[i], &size);
        f->size[i] = size;
        fly_to(f, flock, i, first, nodes, blocks);
    }
}

// One block for each of the `count` rays in `ray`, likewise.
ALWAYS_INLINE void visit_blocks(Flying *f, Flock *flock, const uint *ray, uint count, RayStream *stream,
                                const StreamSetup *setup, global const float *nodes, global const float *blocks, int meet) {
    uint met[STREAM_RAYS];
    Row distance[STREAM_RAYS], area[STREAM_RAYS];
    for (uint n = 0u; n < count; n++) {
        const uint i = ray[n];
        const Shear shear = shear_in(setup, i);
        const uint block = f->current[i] & BVH_LEAF_FIRST_MASK;
        met[n] = triangles_hit(&shear, blocks + (size_t)block * (BVH_BLOCK_ROWS * BVH_WIDTH), stream->t_min[i],
                               stream->t[i], &distance[n], &area[n]);
    }
    for (uint n = 0u; n < count; n++) {
        const uint i = ray[n], leaf = f->current[i], block = leaf & BVH_LEAF_FIRST_MASK;
        if (meet == MEET_FLIGHT && met[n] != 0u) {
            const Ray flight = stream_ray(stream, i);
            met[n] &= ~ground_below(blocks, block, 0u, met[n], (const float *)&distance[n], (const float *)&area[n],
                                    flight.origin, flight.direction);
        }
        if (meet == MEET_ANY && met[n] != 0u) {
            stream->block[i] = block;
            continue;
        }
        Hit hit;
        hit.t = stream->t[i];
        if (met[n] != 0u) {
            hit.block = stream->block[i];
            hit.slot = stream->slot[i];
            take_hits(blocks, block, 0u, met[n], (const float *)&distance[n], (const float *)&area[n], stream->t_min[i], &hit);
            stream->t[i] = hit.t;
            stream->block[i] = hit.block;
            stream->slot[i] = hit.slot;
        }
        if (leaf_blocks(leaf) > 1u) // on to the leaf's next block
            fly_to(f, flock, i, leaf + 1u - (1u << BVH_LEAF_COUNT_SHIFT), nodes, blocks);
        else
            fly_back(f, flock, i, hit.t, nodes, blocks);
    }
}

// Traces the rays whose bits are set in `wanted` for the hits that `meet` asks for. All are under way at once:
// starting a ray whenever one ends, so that as many stay under way, cost 10 %.
void trace_stream(RayStream *stream, ulong wanted, global const float *nodes, global const float *blocks, int meet
                  AND_PROFILED(uint *visits)) {
    StreamSetup setup;
    Flying flying;
    Flock flock = {0u, 0u};
    for (ulong rest = wanted; rest != 0ul; rest &= rest - 1ul) {
        const uint i = lowest_bit64(rest);
        stream->block[i] = stream->slot[i] = BVH_NO_PRIMITIVE;
    }
    for (ulong rest = set_up_stream(&setup, stream, wanted, nodes); rest != 0ul; rest &= rest - 1ul) {
        const uint i = lowest_bit64(rest);
        flying.size[i] = 0u;
        fly_to(&flying, &flock, i, stream->root[i], nodes, blocks);
    }
    while (flock.nodes + flock.leaves != 0u) {
        uint at_leaf[STREAM_RAYS];
        const uint leaves = flock.leaves;
        for (uint n = 0u; n < leaves; n++) at_leaf[n] = flying.at_leaf[n];
        flock.leaves = 0u;
        PROFILED(visits[0] += flock.nodes;)
        PROFILED(visits[1] += leaves;)
        visit_nodes(&flying, &flock, stream, &setup, nodes, blocks);
        visit_blocks(&flying, &flock, at_leaf, leaves, stream, &setup, nodes, blocks, meet);
    }
}

#endif

#endif
