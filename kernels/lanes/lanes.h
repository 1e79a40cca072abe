// Lane types: LANES walks side by side in one work-item. phase, flight and walk are written over them; with LANES = 1
// they are plain scalars. Never a bare ?:, any() or select(): a vector's true is -1, a scalar's is 1.
#ifndef NACRE_LANES_LANES_H
#define NACRE_LANES_LANES_H

#include "lanes/bits.h"

#ifndef LANES
#define LANES 1
#endif

#define LANES_JOIN_(a, b) a##b
#define LANES_JOIN(a, b) LANES_JOIN_(a, b)

#if LANES == 1
typedef float real;
typedef int whole;
typedef uint natural;
typedef int mask;
#define pick(m, a, b) ((m) ? (a) : (b))
#define to_whole(x) convert_int_rtz(x)
#define to_real(x) convert_float(x)
#define as_natural(x) as_uint(x)
#define as_whole(x) as_int(x)
#define as_real(x) as_float(x)
#define MASK_TRUE 1
uint bits(mask m) { return m != 0 ? 1u : 0u; }
mask mask_of(uint set) { return set != 0u; }
#else
typedef LANES_JOIN(float, LANES) real;
typedef LANES_JOIN(int, LANES) whole;
typedef LANES_JOIN(uint, LANES) natural;
typedef LANES_JOIN(int, LANES) mask;
#define pick(m, a, b) select((b), (a), (m))
#define to_whole(x) LANES_JOIN(LANES_JOIN(convert_int, LANES), _rtz)(x)
#define to_real(x) LANES_JOIN(convert_float, LANES)(x)
#define as_natural(x) LANES_JOIN(as_uint, LANES)(x)
#define as_whole(x) LANES_JOIN(as_int, LANES)(x)
#define as_real(x) LANES_JOIN(as_float, LANES)(x)
#define MASK_TRUE -1
uint bits(mask m) { return LANES_JOIN(bits, LANES)(m); }
mask mask_of(uint set) {
    const uint16 lane = (uint16)(1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384, 32768);
#if LANES == 16
    return (set & lane) != 0u;
#elif LANES == 8
    return (set & lane.lo) != 0u;
#else
    return (set & lane.lo.lo) != 0u;
#endif
}
#endif

#define LANES_ALL (0xffffffffu >> (32 - LANES))

// Runs what follows for each l whose bit is set. With one lane l is a constant, so that the lane's values stay in registers.
#if LANES == 1
#define FOR_BITS(l, set) for (uint l = 0u, once_##l = (set); once_##l != 0u; once_##l = 0u)
#else
#define FOR_BITS(l, set)                                                                                               \
    for (uint rest_##l = (set), l = lowest_bit(rest_##l); rest_##l != 0u; rest_##l &= rest_##l - 1u, l = lowest_bit(rest_##l))
#endif

// One lane's value of a real, a whole or a natural; can be assigned to.
#if LANES == 1
#define LANE_FLOAT(x, l) (x)
#define LANE_INT(x, l) (x)
#define LANE_UINT(x, l) (x)
#else
#define LANE_FLOAT(x, l) (((float *)&(x))[l])
#define LANE_INT(x, l) (((int *)&(x))[l])
#define LANE_UINT(x, l) (((uint *)&(x))[l])
#endif

typedef struct {
    real x, y, z;
} real3;

real3 triple(real x) {
    real3 r;
    r.x = x;
    r.y = x;
    r.z = x;
    return r;
}

real largest(real3 v) { return max(v.x, max(v.y, v.z)); }

real dot3(real3 a, real3 b) { return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z)); }

// Of three channels' values that of `channel`, 0 to 2.
real channel_of(real x, real y, real z, whole channel) { return pick(channel == 0, x, pick(channel == 1, y, z)); }

real3 pick3(mask m, real3 a, real3 b) {
    real3 r;
    r.x = pick(m, a.x, b.x);
    r.y = pick(m, a.y, b.y);
    r.z = pick(m, a.z, b.z);
    return r;
}

#endif
