// Counter-based random numbers: four words from four words, without state.
// PCG4D of Jarzynski & Olano 2020, "Hash Functions for GPU Rendering" (JCGT 9:3).
#ifndef NACRE_RANDOM_HASH_H
#define NACRE_RANDOM_HASH_H

#include "lanes/lanes.h"

uint4 random_hash(uint4 v) {
    uint x = v.x * 1664525u + 1013904223u, y = v.y * 1664525u + 1013904223u;
    uint z = v.z * 1664525u + 1013904223u, w = v.w * 1664525u + 1013904223u;
    x += y * w;
    y += z * x;
    z += x * y;
    w += y * z;
    x ^= x >> 16u;
    y ^= y >> 16u;
    z ^= z >> 16u;
    w ^= w >> 16u;
    x += y * w;
    y += z * x;
    z += x * y;
    w += y * z;
    return (uint4)(x, y, z, w);
}

// A float in (0, 1), never 0 or 1: (k + 1/2) 2^-23, exact in float.
float random_unit(uint bits) { return ((float)(bits >> 9) + 0.5f) * 0x1p-23f; }

// The same over lanes: each gets the words that random_hash gives for its own.
typedef struct {
    natural x, y, z, w;
} Natural4;

Natural4 lane_hash(natural x, natural y, natural z, natural w) {
    Natural4 v;
    v.x = x * 1664525u + 1013904223u;
    v.y = y * 1664525u + 1013904223u;
    v.z = z * 1664525u + 1013904223u;
    v.w = w * 1664525u + 1013904223u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    v.x ^= v.x >> 16u;
    v.y ^= v.y >> 16u;
    v.z ^= v.z >> 16u;
    v.w ^= v.w >> 16u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    return v;
}

real lane_unit(natural bits) { return (to_real(as_whole(bits >> 9u)) + 0.5f) * 0x1p-23f; }

#endif
