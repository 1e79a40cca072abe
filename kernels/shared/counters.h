// What the kernels count. Each group adds to one of COUNTER_SLICES copies, so that cores do not fight over a cache line.
#ifndef NACRE_SHARED_COUNTERS_H
#define NACRE_SHARED_COUNTERS_H

#include "shared/types.h"

#define COUNTER_LIST(X)                                                                                                \
    X(paths)                                                                                                           \
    X(rays)          /* closest-hit rays outside of walks; one that paths share, for each */                           \
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

// What only a program with -DPROFILE counts. Nodes and blocks of a kind of ray stand side by side: a traversal gets the
// address of the first.
#define PROFILE_LIST(X)                                                                                                \
    X(ray_nodes)     /* BVH nodes that rays outside of walks opened */                                                 \
    X(ray_blocks)    /* triangle blocks that they tested */                                                            \
    X(shadow_nodes)                                                                                                    \
    X(shadow_blocks)                                                                                                   \
    X(walk_nodes)                                                                                                      \
    X(walk_blocks)                                                                                                     \
    X(clear_steps)   /* flights that needed no ray */                                                                  \
    X(lane_turns)    /* turns of a worker's lanes: a flight in each that has a walk */                                 \
    X(lane_active)   /* lanes that had one, summed over the turns */

SHARED_BEGIN

enum Counter {
#define COUNTER_ENUM(name) COUNTER_##name,
    COUNTER_LIST(COUNTER_ENUM)
#undef COUNTER_ENUM
    COUNTER_COUNT
};

#if defined(PROFILE) || !defined(__OPENCL_C_VERSION__)
enum ProfileCounter {
#define PROFILE_ENUM(name) PROFILE_##name,
    PROFILE_LIST(PROFILE_ENUM)
#undef PROFILE_ENUM
    PROFILE_COUNT
};
#endif

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

// With -DPROFILE there follow, in as many slices: PROFILE_LIST, a histogram of steps per walk, and the most steps of one.
#define PROFILE_BINS 96 // quarters of an octave (1, 2, … 7 each its own) up to 2^25, the last one open
#define PROFILE_HISTOGRAM PROFILE_COUNT
#define PROFILE_MOST_STEPS (PROFILE_HISTOGRAM + PROFILE_BINS)
#define PROFILE_USED (PROFILE_MOST_STEPS + 1)
#define PROFILE_STRIDE ((PROFILE_USED + 15) / 16 * 16)
#define PROFILE_TAIL (COUNTER_TAIL + 16)
#define PROFILE_WORDS (PROFILE_TAIL + COUNTER_SLICES * PROFILE_STRIDE)

// PROFILED(tokens): only with -DPROFILE. It brings its own semicolon, so that without PROFILE nothing is left; never the one
// statement of an `if` without braces, for the same reason. AND_PROFILED is the last of some arguments. One token list each:
// OpenCL C 1.2 knows no macros with any number of arguments, and NVIDIA's compiler takes none.
#ifdef PROFILE
#define PROFILED(tokens) tokens
#define AND_PROFILED(argument) , argument
#else
#define PROFILED(tokens)
#define AND_PROFILED(argument)
#endif

#endif
