// Owen-scrambled, shuffled (0,2)-sequence: pairs of numbers that fill the unit square evenly over the samples of a pixel.
// Scrambling by hashing: Laine & Karras 2011 in Vegdahl's form; shuffling and padding of pairs: Burley 2020, "Practical
// Hash-based Owen Scrambling" (JCGT 9:4). Sobol's second dimension in the bit-reversed order is Pascal's triangle mod 2.
#ifndef NACRE_RANDOM_SOBOL_H
#define NACRE_RANDOM_SOBOL_H

#include "random/hash.h"

uint reverse_bits(uint x) {
    x = as_uint(as_uchar4(x).wzyx); // one instruction
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    return ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
}

// On CPUs scrambling is not inlined: LLVM would scramble both numbers of a pair in a vector, where a product takes three times
// as long and is waited for. A head's samples took 2 % longer for it.
#if LANES > 1
#define APART __attribute__((noinline))
#else
#define APART
#endif

// Owen scrambling of a bit-reversed number: each bit is flipped depending on the bits below it.
APART uint scramble_reversed(uint x, uint seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

// Sobol's second dimension, bit-reversed: bit j is the parity of the bits k of `index` with C(k, j) odd.
uint sobol_second_reversed(uint index) {
    index ^= (index >> 1) & 0x55555555u;
    index ^= (index >> 2) & 0x33333333u;
    index ^= (index >> 4) & 0x0f0f0f0fu;
    index ^= (index >> 8) & 0x00ff00ffu;
    index ^= (index >> 16) & 0x0000ffffu;
    return index;
}

// Pair `sample` of the sequence that belongs to (key, dimension): two words.
uint2 sobol_pair(uint key, uint dimension, uint sample) {
    const uint4 seed = random_hash((uint4)(key, dimension, 0x9e3779b9u, 0x7f4a7c15u));
    const uint index = reverse_bits(scramble_reversed(reverse_bits(sample), seed.x));
    return (uint2)(reverse_bits(scramble_reversed(index, seed.y)),
                   reverse_bits(scramble_reversed(sobol_second_reversed(index), seed.z)));
}

#endif
