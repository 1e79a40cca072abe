// A row of a node or a leaf block: BVH_WIDTH floats at once (BVH_VECTOR = 1, CPUs) or one at a time (0, GPUs).
#ifndef NACRE_GEOMETRY_TRAVERSE_ROW_H
#define NACRE_GEOMETRY_TRAVERSE_ROW_H

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

// A row of truth values as bits, slot 0 lowest. LLVM does not find the one instruction that x86 has for it: builtins
// win 10-20 % of a whole traversal over the multiplication, which gathers one bit of each of eight bytes.
#if !BVH_VECTOR
uint row_bits(RowMask m) { return m != 0 ? 1u : 0u; }
#elif BVH_WIDTH == 16 && defined(__AVX512VL__)
typedef int Int16Native __attribute__((__vector_size__(64)));
uint row_bits(RowMask m) {
    return (ushort)__builtin_ia32_cmpd512_mask((Int16Native)m, (Int16Native)(int16)(0), 1 /* less than */, (ushort)-1);
}
#elif BVH_WIDTH == 8 && defined(__AVX__)
typedef float Float8Native __attribute__((__vector_size__(32)));
uint row_bits(RowMask m) { return (uint)__builtin_ia32_movmskps256((Float8Native)as_float8(m)); }
#elif BVH_WIDTH == 4 && defined(__AVX__)
typedef float Float4Native __attribute__((__vector_size__(16)));
uint row_bits(RowMask m) { return (uint)__builtin_ia32_movmskps((Float4Native)as_float4(m)); }
#elif BVH_WIDTH == 16
uint row_bits(RowMask m) {
    const ulong2 b = ((as_ulong2(convert_char16(m)) & 0x8040201008040201ul) * 0x0101010101010101ul) >> 56;
    return (uint)(b.x | b.y << 8);
}
#elif BVH_WIDTH == 8
uint row_bits(RowMask m) {
    return (uint)(((as_ulong(convert_char8(m)) & 0x8040201008040201ul) * 0x0101010101010101ul) >> 56);
}
#else
uint row_bits(RowMask m) { return ((as_uint(convert_char4(m)) & 0x08040201u) * 0x01010101u) >> 24; }
#endif

// Index of the lowest set bit of a number that is not 0. LLVM makes one instruction of it, unlike of clz(bits & -bits).
uint lowest_bit(uint bits) { return popcount(~bits & (bits - 1u)); }
uint lowest_bit64(ulong bits) { return (uint)popcount(~bits & (bits - 1ul)); }

// The lowest `count` bits, 1 to 64.
ulong first_bits(uint count) { return ~0ul >> (64u - count); }

#endif
