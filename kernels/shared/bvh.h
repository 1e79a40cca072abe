// Layout of the flattened BVH. Node and leaf block are rows of floats, so that one ray meets a whole node (or block of
// triangles) in one vector operation per row. W = BVH_WIDTH children per node, and as many triangles per leaf block.
//
//   node  (8 W floats): rows lower x, upper x, lower y, upper y, lower z, upper z, child (uint bits), extent
//         (slot 0 of a root: the largest |coordinate| of the tree, which bounds the rounding of its vertices)
//   block (10 W floats): rows v0.x v0.y v0.z v1.x v1.y v1.z v2.x v2.y v2.z, primitive (uint bits)
//
// Empty slots of a node have lower = BVH_EMPTY, upper = -BVH_EMPTY; empty slots of a block have all vertices 0 and
// primitive = BVH_NO_PRIMITIVE: a triangle without area is never hit.
#ifndef NACRE_SHARED_BVH_H
#define NACRE_SHARED_BVH_H

#define BVH_NODE_ROWS 8
#define BVH_ROW_CHILD 6
#define BVH_ROW_EXTENT 7
#define BVH_BLOCK_ROWS 10
#define BVH_ROW_PRIMITIVE 9
#define BVH_EMPTY 1e30f
#define BVH_NO_PRIMITIVE 0xffffffffu

// A child is a node index, or a leaf: bit 31 set, bits 28-30 number of blocks - 1, bits 0-27 first block.
#define BVH_LEAF_BIT 0x80000000u
#define BVH_LEAF_COUNT_SHIFT 28
#define BVH_LEAF_COUNT_MASK 7u
#define BVH_LEAF_FIRST_MASK 0x0fffffffu

#endif
