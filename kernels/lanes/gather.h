// Reads one element per lane. Spelled out element by element, PoCL makes one gather instruction of it, where there is any.
#ifndef NACRE_LANES_GATHER_H
#define NACRE_LANES_GATHER_H

#include "lanes/lanes.h"

// The int or uint at p[i] of each lane, as a `whole`.
#if LANES == 1
#define gather(p, i) ((whole)(p)[i])
#elif LANES == 4
#define gather(p, i) ((whole)((p)[(i).s0], (p)[(i).s1], (p)[(i).s2], (p)[(i).s3]))
#elif LANES == 8
#define gather(p, i)                                                                                                   \
    ((whole)((p)[(i).s0], (p)[(i).s1], (p)[(i).s2], (p)[(i).s3], (p)[(i).s4], (p)[(i).s5], (p)[(i).s6], (p)[(i).s7]))
#else
#define gather(p, i)                                                                                                   \
    ((whole)((p)[(i).s0], (p)[(i).s1], (p)[(i).s2], (p)[(i).s3], (p)[(i).s4], (p)[(i).s5], (p)[(i).s6], (p)[(i).s7],   \
             (p)[(i).s8], (p)[(i).s9], (p)[(i).sa], (p)[(i).sb], (p)[(i).sc], (p)[(i).sd], (p)[(i).se], (p)[(i).sf]))
#endif

#endif
