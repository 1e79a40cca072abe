// Lane types: LANES walks side by side in one work-item. phase, flight and walk are written over them; with LANES = 1
// they are plain scalars. Never a bare ?:, any() or select(): a vector's true is -1, a scalar's is 1.
#ifndef NACRE_LANES_LANES_H
#define NACRE_LANES_LANES_H

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
uint bits(mask m) { return m != 0 ? 1u : 0u; }
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
#if LANES == 4
uint bits(mask m) {
    const int4 b = m & (int4)(1, 2, 4, 8);
    return (uint)(b.x | b.y | b.z | b.w);
}
#elif LANES == 8
uint bits(mask m) {
    const int8 b = m & (int8)(1, 2, 4, 8, 16, 32, 64, 128);
    const int4 h = b.lo | b.hi;
    return (uint)(h.x | h.y | h.z | h.w);
}
#else
uint bits(mask m) {
    const int16 b = m & (int16)(1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384, 32768);
    const int8 h = b.lo | b.hi;
    const int4 q = h.lo | h.hi;
    return (uint)(q.x | q.y | q.z | q.w);
}
#endif
#endif

typedef struct {
    real x, y, z;
} real3;

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
