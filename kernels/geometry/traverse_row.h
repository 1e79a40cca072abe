// A row of a node or a leaf block: BVH_WIDTH floats at once (BVH_VECTOR = 1, CPUs) or one at a time (0, GPUs).
#ifndef NACRE_GEOMETRY_TRAVERSE_ROW_H
#define NACRE_GEOMETRY_TRAVERSE_ROW_H

#include "lanes/bits.h"

#ifndef BVH_WIDTH
#define BVH_WIDTH 8 // children per node, triangles per leaf block: 16, 8 or 4
#endif
#ifndef BVH_VECTOR
#define BVH_VECTOR 1
#endif

// LLVM leaves a visit's functions apart when they have two callers, which costs 10 % of a ray: what they share in registers
// goes through memory.
#define ALWAYS_INLINE __attribute__((always_inline))

#define ROW_JOIN_(a, b) a##b
#define ROW_JOIN(a, b) ROW_JOIN_(a, b)

#if BVH_VECTOR
#define ROW_SIZE BVH_WIDTH
typedef ROW_JOIN(float, BVH_WIDTH) Row;
typedef ROW_JOIN(uint, BVH_WIDTH) RowBits;
typedef ROW_JOIN(int, BVH_WIDTH) RowMask;
#define as_row(x) ROW_JOIN(as_float, BVH_WIDTH)(x)
#define as_row_bits(x) ROW_JOIN(as_uint, BVH_WIDTH)(x)
#else
#define ROW_SIZE 1
typedef float Row;
typedef uint RowBits;
typedef int RowMask;
#define as_row(x) as_float(x)
#define as_row_bits(x) as_uint(x)
#endif

// Rows start at multiples of their size: nodes and blocks do, and buffers are aligned to the largest vector.
Row load_row(global const float *row) { return *(global const Row *)row; }

// A row of truth values as bits, slot 0 lowest.
#if BVH_VECTOR
uint row_bits(RowMask m) { return ROW_JOIN(bits, BVH_WIDTH)(m); }
#else
uint row_bits(RowMask m) { return m != 0 ? 1u : 0u; }
#endif

#endif
