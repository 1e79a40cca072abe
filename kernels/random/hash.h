// Counter-based random numbers: four words from four words, without state.
// PCG4D of Jarzynski & Olano 2020, "Hash Functions for GPU Rendering" (JCGT 9:3).
#ifndef NACRE_RANDOM_HASH_H
#define NACRE_RANDOM_HASH_H

uint4 random_hash(uint4 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    v ^= v >> 16u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    return v;
}

// A float in (0, 1), never 0 or 1: (k + 1/2) 2^-23, exact in float.
float random_unit(uint bits) { return ((float)(bits >> 9) + 0.5f) * 0x1p-23f; }

#endif
