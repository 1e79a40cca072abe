// What the kernels count. Each group adds to one of COUNTER_SLICES copies, so that cores do not fight over a cache line.
#ifndef NACRE_SHARED_COUNTERS_H
#define NACRE_SHARED_COUNTERS_H

#include "shared/types.h"

#define COUNTER_LIST(X)                                                                                                \
    X(paths)                                                                                                           \
    X(rays)          /* closest-hit rays outside of walks */                                                           \
    X(shadow_rays)                                                                                                     \
    X(walk_rays)     /* segments of flights that were traced */                                                        \
    X(walks)                                                                                                           \
    X(steps)         /* flights of walks */                                                                            \
    X(escaped)       /* walks that left through a hole of an open mesh: their energy is lost */                        \
    X(missed)        /* walks that missed the surface of a closed mesh by rounding: they leave where they are */       \
    X(capped)        /* walks ended by subsurface_max_depth: their energy is lost */                                   \
    X(capped_energy) /* what they carried, in units of COUNTER_ENERGY */                                               \
    X(roulette)      /* walks and paths ended by roulette */                                                           \
    X(non_finite)    /* samples that were NaN or infinite, replaced by black */

SHARED_BEGIN

enum Counter {
#define COUNTER_ENUM(name) COUNTER_##name,
    COUNTER_LIST(COUNTER_ENUM)
#undef COUNTER_ENUM
    COUNTER_COUNT
};

SHARED_END

#define COUNTER_SLICES 64
#define COUNTER_STRIDE 16                      // uints per slice: one cache line
#define COUNTER_ENERGY 4096                    // counts per unit of throughput
#define COUNTER_TAIL (COUNTER_SLICES * COUNTER_STRIDE) // after the slices: this launch, and the first non-finite sample
#define COUNTER_SUSPENDED (COUNTER_TAIL + 0)  // paths left to the next launch
#define COUNTER_NEXT (COUNTER_TAIL + 1)        // first path of the launch that no worker has taken
#define COUNTER_BAD_PIXEL (COUNTER_TAIL + 2)   // pixel + 1, 0: none
#define COUNTER_BAD_SAMPLE (COUNTER_TAIL + 3)
#define COUNTER_BAD_STEP (COUNTER_TAIL + 4)    // vertex << 24 | scatters of its last walk
#define COUNTER_WORDS (COUNTER_TAIL + 5)

#endif
