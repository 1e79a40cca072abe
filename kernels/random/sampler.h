// The random numbers of a path, by name. A number depends on (seed, pixel, sample, vertex, name, step) alone, so leaving a
// feature out shifts nothing. The first vertices take Owen-scrambled Sobol pairs, everything after hashed numbers.
#ifndef NACRE_RANDOM_SAMPLER_H
#define NACRE_RANDOM_SAMPLER_H

#include "random/sobol.h"
#include "shared/path.h"

typedef enum {
    DRAW_PIXEL,      // position in the pixel
    DRAW_LENS,
    DRAW_LOBE,       // reflection against base; subsurface against diffuse
    DRAW_MICROFACET,
    DRAW_DIRECTION,  // cosine-weighted direction, of the diffuse lobe or at the exit
    DRAW_ENTRY,      // direction into the medium
    DRAW_FIRST,      // channel and first flight of a walk
    DRAW_LIGHT,      // few lights: which, and where on it; many: entry of the alias table, and whether to keep it
    DRAW_LIGHT_POINT, // many lights: where on it; few: which of several draws
    DRAW_TEXEL,      // of an environment image
    DRAW_ROULETTE,
    DRAW_WALK,       // one per flight of a walk: length, cosine, azimuth, roulette
    DRAW_WALK_CHOICE, // one per flight: channel, technique, technique of the length
    DRAW_WALK_TRY,    // one per try of a guided direction: cosine, azimuth, whether to keep it
    DRAW_COUNT
} Draw;

// Vertices whose draws are Sobol pairs: the first surface, the exit of its walk, and one more. After that the integrand has
// too many dimensions for it to matter. 0: none, every number is hashed.
#ifndef SOBOL_VERTICES
#define SOBOL_VERTICES 3u
#endif

typedef struct {
    uint key;    // of seed, pixel and half
    uint sample;
    uint vertex;
} Sampler;

// Samples of the second half (shared/path.h) have a scrambling of their own.
uint sampler_key(uint seed, uint pixel, uint sample) {
    return random_hash((uint4)(seed, pixel, 0x85ebca6bu ^ (sample >> 31), 0xc2b2ae35u)).x;
}

Sampler sampler_with(uint key, uint sample, uint vertex) {
    Sampler sampler;
    sampler.key = key;
    sampler.sample = sample;
    sampler.vertex = vertex;
    return sampler;
}

Sampler sampler_of(uint seed, uint pixel, uint sample, uint vertex) {
    return sampler_with(sampler_key(seed, pixel, sample), sample, vertex);
}

// For what happens at the path's vertex.
Sampler path_sampler(const PATH_SPACE Path *path) { return sampler_with(path->key, path->sample, path->vertex); }

uint4 draw_bits(Sampler sampler, Draw name, uint step) {
    return random_hash((uint4)(sampler.key, sampler.sample, sampler.vertex * (uint)DRAW_COUNT + (uint)name, step));
}

// The same for each lane of a turn.
typedef struct {
    natural key, sample, vertex;
} LaneSampler;

Natural4 lane_draw(LaneSampler sampler, Draw name, natural step) {
    return lane_hash(sampler.key, sampler.sample, sampler.vertex * (uint)DRAW_COUNT + (uint)name, step);
}

// Two words; their upper bits are the even ones.
uint2 draw_words(Sampler sampler, Draw name) {
    const uint dimension = sampler.vertex * (uint)DRAW_COUNT + (uint)name;
    return sampler.vertex < SOBOL_VERTICES ? sobol_pair(sampler.key, dimension, sampler.sample)
                                           : draw_bits(sampler, name, 0u).xy;
}

// Two numbers in (0, 1).
float2 draw_pair(Sampler sampler, Draw name) {
    const uint2 word = draw_words(sampler, name);
    return (float2)(random_unit(word.x), random_unit(word.y));
}

#endif
