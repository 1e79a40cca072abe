// One ray through the BVH of shared/bvh.h: nearest child first, the others on a stack with the distance to their boxes.
#ifndef NACRE_GEOMETRY_TRAVERSE_H
#define NACRE_GEOMETRY_TRAVERSE_H

#include "geometry/ray.h"
#include "geometry/traverse_box.h"
#include "geometry/traverse_row.h"
#include "geometry/traverse_triangle.h"
#include "shared/bvh.h"

#ifndef BVH_STACK
#define BVH_STACK 64 // entries, at least Bvh::stack of the tree
#endif

#define BVH_NO_CHILD 0xffffffffu

// False for what cannot hit anything and might make the boxes' arithmetic meaningless: NaN, infinity, a zero direction.
bool is_traceable(Ray ray) {
    const float3 o = fabs(ray.origin), d = fabs(ray.direction);
    const float length = d.x + d.y + d.z;
    return length > 1e-6f && length < 1e6f && o.x + o.y + o.z < 1e18f;
}

// Child of `node` that the ray enters first, or BVH_NO_CHILD; the others that it enters go on the stack.
uint enter_node(const Slabs *slabs, global const float *node, float t_min, float t_max, uint *stack, float *stack_t,
                uint *size) {
    global const uint *child = (global const uint *)(node + BVH_ROW_CHILD * BVH_WIDTH);
    uint first = BVH_NO_CHILD;
    float first_t = 0.0f;
    for (uint slot = 0; slot < BVH_WIDTH; slot += ROW_SIZE) {
        Row near;
        uint bits = boxes_hit(slabs, node + slot, t_min, t_max, &near);
        const float *near_t = (const float *)&near;
        for (; bits != 0u; bits &= bits - 1u) {
            const uint i = lowest_bit(bits), other = child[slot + i];
            const float t = near_t[i];
            if (first == BVH_NO_CHILD) {
                first = other;
                first_t = t;
                continue;
            }
            const bool closer = t < first_t;
            stack[*size] = closer ? first : other;
            stack_t[*size] = closer ? first_t : t;
            first = closer ? other : first;
            first_t = closer ? t : first_t;
            (*size)++;
        }
    }
    return first;
}

// Closest hit in a leaf, if it is closer than hit->t. True as soon as there is one if any will do.
bool meet_leaf(const Shear *shear, global const float *blocks, uint leaf, float t_min, bool any, Hit *hit) {
    const uint first = leaf & BVH_LEAF_FIRST_MASK;
    const uint last = first + ((leaf >> BVH_LEAF_COUNT_SHIFT) & BVH_LEAF_COUNT_MASK);
    for (uint block = first; block <= last; block++) {
        global const float *rows = blocks + (size_t)block * (BVH_BLOCK_ROWS * BVH_WIDTH);
        for (uint slot = 0; slot < BVH_WIDTH; slot += ROW_SIZE) {
            Row distance, area;
            uint bits = triangles_hit(shear, rows + slot, t_min, hit->t, &distance, &area);
            if (any && bits != 0u) return true;
            for (; bits != 0u; bits &= bits - 1u) {
                const uint i = lowest_bit(bits);
                const float t = ((const float *)&distance)[i] / ((const float *)&area)[i];
                if (!(t > t_min && t <= hit->t)) continue;
                hit->t = t;
                hit->block = block;
                hit->slot = slot + i;
            }
        }
    }
    return false;
}

// Walks the tree at `root`. With `any`, stops at the first hit; true: something was hit, and unless `any`, *hit is the closest.
bool traverse(Ray ray, global const float *nodes, global const float *blocks, uint root, bool any, Hit *hit) {
    hit->t = ray.t_max;
    hit->block = hit->slot = BVH_NO_PRIMITIVE;
    hit->primitive = BVH_NO_PRIMITIVE;
    if (!is_traceable(ray)) return false;

    const Shear shear = shear_of(ray);
    const float extent = (root & BVH_LEAF_BIT) ? 0.0f : nodes[((size_t)root * BVH_NODE_ROWS + BVH_ROW_EXTENT) * BVH_WIDTH];
    const Slabs slabs = slabs_of(ray, extent);
    uint stack[BVH_STACK];
    float stack_t[BVH_STACK];
    uint size = 0, current = root;
    for (;;) {
        while (!(current & BVH_LEAF_BIT))
            current = enter_node(&slabs, nodes + (size_t)current * (BVH_NODE_ROWS * BVH_WIDTH), ray.t_min, hit->t, stack,
                                 stack_t, &size);
        if (current != BVH_NO_CHILD && meet_leaf(&shear, blocks, current, ray.t_min, any, hit)) return true;
        do {
            if (size == 0u) goto done;
            size--;
            current = stack[size];
        } while (stack_t[size] > hit->t);
    }
done:
    if (hit->block == BVH_NO_PRIMITIVE) return false;
    hit->primitive = ((global const uint *)blocks)[((size_t)hit->block * BVH_BLOCK_ROWS + BVH_ROW_PRIMITIVE) * BVH_WIDTH +
                                                   hit->slot];
    return true;
}

Hit trace_closest(Ray ray, global const float *nodes, global const float *blocks, uint root) {
    Hit hit;
    traverse(ray, nodes, blocks, root, false, &hit);
    return hit;
}

int trace_any(Ray ray, global const float *nodes, global const float *blocks, uint root) {
    Hit hit;
    return traverse(ray, nodes, blocks, root, true, &hit) ? 1 : 0;
}

#endif
