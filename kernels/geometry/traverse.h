// One ray through the BVH of shared/bvh.h: nearest child first, the others on a stack with the distance to their boxes.
#ifndef NACRE_GEOMETRY_TRAVERSE_H
#define NACRE_GEOMETRY_TRAVERSE_H

#include "geometry/ray.h"
#include "geometry/traverse_box.h"
#include "geometry/traverse_row.h"
#include "geometry/traverse_triangle.h"
#include "shared/bvh.h"
#include "shared/counters.h"

#pragma OPENCL FP_CONTRACT OFF

#ifndef BVH_STACK
#define BVH_STACK 64 // entries, at least Bvh::stack of the tree
#endif

#define BVH_NO_CHILD 0xffffffffu

// Largest |coordinate| of the tree, which bounds the rounding of its vertices. A tree of a single leaf has no boxes.
float tree_extent(global const float *nodes, uint root) {
    const size_t row = (size_t)root * BVH_NODE_ROWS + BVH_ROW_EXTENT;
    return (root & BVH_LEAF_BIT) ? 0.0f : nodes[row * BVH_WIDTH];
}

// What a ray asks for.
#define MEET_CLOSEST 0
#define MEET_ANY 1    // is anything in the way?
#define MEET_FLIGHT 2 // the closest, but for the ground that it starts from, see ground_below

// False for what cannot hit anything and would make the boxes' arithmetic meaningless: NaN, infinity, a zero direction.
bool is_traceable(float3 origin, float3 direction) {
    const float3 o = fabs(origin), d = fabs(direction);
    const float length = d.x + d.y + d.z;
    return length > 1e-6f && length < 1e6f && o.x + o.y + o.z < 1e18f;
}

// One more child that the ray enters: the closer of it and *first stays, the other goes on the stack.
void push_farther(uint child, float t, uint *first, float *first_t, uint *stack, float *stack_t, uint *size) {
    const bool closer = t < *first_t;
    stack[*size] = closer ? *first : child;
    stack_t[*size] = closer ? *first_t : t;
    *first = closer ? child : *first;
    *first_t = closer ? t : *first_t;
    (*size)++;
}

// The children whose `bits` are set, at least one: the closest of them and *first stays, the others go on the stack.
ALWAYS_INLINE void enter_children(global const uint *child, const float *near_t, uint bits, uint *first, float *first_t,
                                  uint *stack, float *stack_t, uint *size) {
    uint i = lowest_bit(bits);
    if (*first == BVH_NO_CHILD) {
        *first = child[i];
        *first_t = near_t[i];
    } else {
        push_farther(child[i], near_t[i], first, first_t, stack, stack_t, size);
    }
    for (bits &= bits - 1u; bits != 0u; bits &= bits - 1u) {
        i = lowest_bit(bits);
        push_farther(child[i], near_t[i], first, first_t, stack, stack_t, size);
    }
}

// Child of `node` that the ray enters first, or BVH_NO_CHILD; the others that it enters go on the stack.
uint enter_node(const Slabs *slabs, global const float *node, float t_min, float t_max, uint *stack, float *stack_t,
                uint *size) {
    uint first = BVH_NO_CHILD;
    float first_t = 0.0f;
    for (uint slot = 0; slot < BVH_WIDTH; slot += ROW_SIZE) {
        global const uint *child = (global const uint *)(node + BVH_ROW_CHILD * BVH_WIDTH + slot);
        Row near;
        const uint bits = boxes_hit(slabs, node + slot, t_min, t_max, &near);
        if (bits != 0u) enter_children(child, (const float *)&near, bits, &first, &first_t, stack, stack_t, size);
    }
    return first;
}

// Whether a hit is nearer than the nearest so far. Of triangles hit at the same t, on a common edge, the first primitive
// counts, so that the order of visits, which depends on how much of a ray is traced, does not show in a picture.
bool is_nearer(global const float *blocks, uint block, uint slot, float t, const Hit *hit) {
    if (t != hit->t || hit->block == BVH_NO_PRIMITIVE) return t <= hit->t;
    return block_primitive(blocks, block, slot) < block_primitive(blocks, hit->block, hit->slot);
}

// Blocks of a leaf.
uint leaf_blocks(uint leaf) { return 1u + ((leaf >> BVH_LEAF_COUNT_SHIFT) & BVH_LEAF_COUNT_MASK); }

// Takes the nearest of a block's hits, those of slot + i for each bit i of `bits`, t = distance / area, if it is nearer than
// *hit.
ALWAYS_INLINE void take_hits(global const float *blocks, uint block, uint slot, uint bits, const float *distance,
                             const float *area, float t_min, Hit *hit) {
    for (; bits != 0u; bits &= bits - 1u) {
        const uint i = lowest_bit(bits);
        const float t = distance[i] / area[i];
        if (!(t > t_min) || !is_nearer(blocks, block, slot + i, t, hit)) continue;
        hit->t = t;
        hit->block = block;
        hit->slot = slot + i;
    }
}

// Those of a block's hits that a flight enters its object by where it stands already, as far as rounding can tell: that of its
// start, and that of the test, which is in proportion to the triangle (see hit_point). So a walk starts on the surface itself,
// not below it, however dense the medium.
ALWAYS_INLINE uint ground_below(global const float *blocks, uint block, uint slot, uint bits, const float *distance,
                                const float *area, float3 origin, float3 direction) {
    const float rounding = POSITION_ROUNDING * max(fabs(origin.x), max(fabs(origin.y), fabs(origin.z)));
    uint ground = 0u;
    for (; bits != 0u; bits &= bits - 1u) {
        const uint i = lowest_bit(bits);
        const float3 v0 = triangle_vertex(blocks, block, slot + i, 0u);
        const float3 e1 = triangle_vertex(blocks, block, slot + i, 1u) - v0;
        const float3 e2 = triangle_vertex(blocks, block, slot + i, 2u) - v0;
        const float3 normal = triangle_normal(e1, e2), size = max(fabs(e1), fabs(e2));
        const float cosine = dot(normal, direction), t = distance[i] / area[i];
        const float blur = 3.0f * rounding + 1e-6f * max(size.x, max(size.y, size.z));
        if (cosine < 0.0f && -cosine * t <= blur * length3(normal)) ground |= bits & (0u - bits);
    }
    return ground;
}

// Hits of a leaf that are closer than hit->t. True as soon as there is one, if any will do.
ALWAYS_INLINE bool meet_leaf(const Shear *shear, global const float *blocks, uint leaf, float3 origin, float3 direction,
                             float t_min, int meet, Hit *hit) {
    const uint first = leaf & BVH_LEAF_FIRST_MASK, end = first + leaf_blocks(leaf);
    for (uint block = first; block < end; block++) {
        global const float *rows = blocks + (size_t)block * (BVH_BLOCK_ROWS * BVH_WIDTH);
        for (uint slot = 0; slot < BVH_WIDTH; slot += ROW_SIZE) {
            Row distance, area;
            uint bits = triangles_hit(shear, rows + slot, t_min, hit->t, &distance, &area);
            if (meet == MEET_FLIGHT && bits != 0u)
                bits &= ~ground_below(blocks, block, slot, bits, (const float *)&distance, (const float *)&area, origin,
                                      direction);
            if (meet == MEET_ANY && bits != 0u) {
                hit->block = block;
                return true;
            }
            take_hits(blocks, block, slot, bits, (const float *)&distance, (const float *)&area, t_min, hit);
        }
    }
    return false;
}

// Walks the tree at `root` for the hit that `meet` asks for, of MEET_ANY its block alone; a miss has block = BVH_NO_PRIMITIVE.
// With PROFILE the nodes and the blocks visited are added to visits[0] and [1].
// The ray comes in pieces because a struct would come through memory, which cost up to 30 % of a ray (PoCL 3.1).
Hit traverse(float3 origin, float3 direction, float t_min, float t_max, global const float *nodes,
             global const float *blocks, uint root, int meet AND_PROFILED(uint *visits)) {
    Hit hit;
    hit.t = t_max;
    hit.block = hit.slot = hit.primitive = BVH_NO_PRIMITIVE;
    if (!is_traceable(origin, direction)) return hit;

    const float3 rcp = ray_reciprocal(direction);
    const Shear shear = shear_of(origin, direction, rcp);
    const Slabs slabs = slabs_of(origin, rcp, tree_extent(nodes, root));
    uint stack[BVH_STACK];
    float stack_t[BVH_STACK];
    uint size = 0, current = root;
    for (;;) {
        while (!(current & BVH_LEAF_BIT)) {
            PROFILED(visits[0]++;)
            current = enter_node(&slabs, nodes + (size_t)current * (BVH_NODE_ROWS * BVH_WIDTH), t_min, hit.t, stack,
                                 stack_t, &size);
        }
        PROFILED(visits[1] += current != BVH_NO_CHILD ? leaf_blocks(current) : 0u;)
        if (current != BVH_NO_CHILD && meet_leaf(&shear, blocks, current, origin, direction, t_min, meet, &hit)) return hit;
        do {
            if (size == 0u) return hit;
            size--;
            current = stack[size];
        } while (stack_t[size] > hit.t);
    }
}

Hit trace_hit(Ray ray, global const float *nodes, global const float *blocks, uint root, int meet
              AND_PROFILED(uint *visits)) {
    Hit hit = traverse(ray.origin, ray.direction, ray.t_min, ray.t_max, nodes, blocks, root, meet AND_PROFILED(visits));
    if (hit.block == BVH_NO_PRIMITIVE) return hit;
    hit.primitive = block_primitive(blocks, hit.block, hit.slot);
    return hit;
}

Hit trace_closest(Ray ray, global const float *nodes, global const float *blocks, uint root AND_PROFILED(uint *visits)) {
    return trace_hit(ray, nodes, blocks, root, MEET_CLOSEST AND_PROFILED(visits));
}

// 1: something is in the way.
int trace_any(Ray ray, global const float *nodes, global const float *blocks, uint root AND_PROFILED(uint *visits)) {
    const Hit hit = traverse(ray.origin, ray.direction, ray.t_min, ray.t_max, nodes, blocks, root, MEET_ANY AND_PROFILED(visits));
    return hit.block != BVH_NO_PRIMITIVE;
}

#endif
