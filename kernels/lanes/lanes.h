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

// Runs what follows for each lane l whose bit is set. With one lane l is a constant, so that the lane's values stay in registers.
#if LANES == 1
#define FOR_LANES(l, set) for (uint l = 0u, once_##l = (set); once_##l != 0u; once_##l = 0u)
#else
#define FOR_LANES(l, set)                                                                                              \
    for (uint rest_##l = (set), l = lowest_bit(rest_##l); rest_##l != 0u; rest_##l &= rest_##l - 1u, l = lowest_bit(rest_##l))
#endif

// One lane's value of a real, a whole or a natural; can be assigned to.
#define LANE_FLOAT(x, l) (((float *)&(x))[l])
#define LANE_INT(x, l) (((int *)&(x))[l])
#define LANE_UINT(x, l) (((uint *)&(x))[l])

typedef struct {
    real x, y, z;
} real3;

real3 pick3(mask m, real3 a, real3 b) {
    real3 r;
    r.x = pick(m, a.x, b.x);
    r.y = pick(m, a.y, b.y);
    r.z = pick(m, a.z, b.z);
    return r;
}

// sin and cos of 2 pi u for u in [0, 1]. Argument reduction is exact in turns; polynomials on [-pi/4, pi/4] from Moshier's
// Cephes (sinf, cosf): within 2 ulp. In place of sincos(), which takes a pointer and is scalar in PoCL. Once over scalars,
// for surfaces, and once over lanes where those are vectors.
#define DEFINE_SINCOS(name, R, W, TO_WHOLE, PICK)                                                                      \
    void name(R u, R *s, R *c) {                                                                                       \
        const R quarter = rint(u * 4.0f);                                                                              \
        const R r = (u - quarter * 0.25f) * 6.28318530717959f;                                                         \
        const W k = TO_WHOLE(quarter);                                                                                 \
        const R r2 = r * r;                                                                                            \
        const R p = fma(r2, fma(r2, (R)(-1.9515295891e-4f), (R)(8.3321608736e-3f)), (R)(-1.6666654611e-1f));           \
        const R q = fma(r2, fma(r2, (R)(2.443315711809948e-5f), (R)(-1.388731625493765e-3f)),                          \
                        (R)(4.166664568298827e-2f));                                                                   \
        const R sine = fma(r * r2, p, r), cosine = fma(r2 * r2, q, fma(r2, (R)(-0.5f), (R)(1.0f)));                    \
        const R a = PICK((k & 1) != 0, cosine, sine), b = PICK((k & 1) != 0, sine, cosine);                            \
        *s = PICK((k & 2) != 0, -a, a);                                                                                \
        *c = PICK(((k + 1) & 2) != 0, -b, b);                                                                          \
    }

#define SCALAR_PICK(m, a, b) ((m) ? (a) : (b))
DEFINE_SINCOS(sincos_scalar, float, int, convert_int_rtz, SCALAR_PICK)
#if LANES == 1
#define sincos_turns sincos_scalar
#else
DEFINE_SINCOS(sincos_turns, real, whole, to_whole, pick)
#endif

#endif
