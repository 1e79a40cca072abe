// Truth values of a vector (-1: true, 0: false) as bits of a number, component 0 lowest. LLVM does not find the one instruction
// that x86 has for it: builtins win 10-20 % of a whole traversal over the multiplication, which gathers one bit of each of
// eight bytes. Never any() or a reduction: these are far slower.
#ifndef NACRE_LANES_BITS_H
#define NACRE_LANES_BITS_H

#ifdef __AVX512VL__
typedef int Int16Native __attribute__((__vector_size__(64)));
uint bits16(int16 m) {
    return (ushort)__builtin_ia32_cmpd512_mask((Int16Native)m, (Int16Native)(int16)(0), 1 /* less than */, (ushort)-1);
}
#else
uint bits16(int16 m) {
    const ulong2 b = ((as_ulong2(convert_char16(m)) & 0x8040201008040201ul) * 0x0101010101010101ul) >> 56;
    return (uint)(b.x | b.y << 8);
}
#endif

#ifdef __AVX__
typedef float Float8Native __attribute__((__vector_size__(32)));
typedef float Float4Native __attribute__((__vector_size__(16)));
uint bits8(int8 m) { return (uint)__builtin_ia32_movmskps256((Float8Native)as_float8(m)); }
uint bits4(int4 m) { return (uint)__builtin_ia32_movmskps((Float4Native)as_float4(m)); }
#else
uint bits8(int8 m) { return (uint)(((as_ulong(convert_char8(m)) & 0x8040201008040201ul) * 0x0101010101010101ul) >> 56); }
uint bits4(int4 m) { return ((as_uint(convert_char4(m)) & 0x08040201u) * 0x01010101u) >> 24; }
#endif

// Index of the lowest set bit of a number that is not 0. LLVM makes one instruction of it, unlike of clz(bits & -bits).
uint lowest_bit(uint bits) { return popcount(~bits & (bits - 1u)); }
uint lowest_bit64(ulong bits) { return (uint)popcount(~bits & (bits - 1ul)); }

// The lowest `count` bits, 1 to 64.
ulong first_bits(uint count) { return ~0ul >> (64u - count); }

#endif
