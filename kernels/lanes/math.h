// Elementary functions over lanes. PoCL's built-ins (SLEEF) are vectors too, for a float8 or float16, but slower: exp little,
// log and log1p several times, expm1 and sincos about ten times at 8 lanes; and nothing promises that scalars and vectors
// agree. Here every lane does the same few operations, explicit ones (fma, no contraction), without branches and tables, so
// that a lane's result is the same to the bit for any LANES.
// Errors are over all floats, in units of the last place, by tests/device/lanes_math.cpp. Polynomials are minimax in
// relative error (Lawson's iteration), their coefficients rounded to float one after the other, lowest first.
#ifndef NACRE_LANES_MATH_H
#define NACRE_LANES_MATH_H

#include "lanes/lanes.h"

#pragma OPENCL FP_CONTRACT OFF

// log(1 + m) for m in [-1/3, 1/3], relative error 2.6e-8 before rounding.
real log_series(real m) {
    const real s = m * m;
    const real a = fma(m, (real)(0.333332002f), (real)(-0.499999374f));
    const real b = fma(m, (real)(0.200110734f), (real)(-0.250077486f));
    const real c = fma(m, (real)(0.139971331f), (real)(-0.164170265f));
    const real d = fma(m, (real)(0.140206009f), (real)(-0.153836325f));
    return fma(s, fma(s, fma(s, fma(s, d, c), b), a), m);
}

// The exponent e, in the place of a float's, that brings x 2^-e into [2/3, 4/3).
natural log_exponent(real x) { return (as_natural(x) - 0x3f2aaaabu) & 0xff800000u; }

// e log(2) + y, with e as log_exponent gives it: a signed number, 2^23 times too large.
real log_sum(natural e, real y) { return fma(to_real(as_whole(e)), (real)(0x1.62e43p-24f), y); }

// Within 1.2 ulp. 0 gives -inf, inf gives inf, below 0 and NaN give NaN; a denormal number gives what some number from
// FLT_MIN / 2 to FLT_MIN does, or -inf where the device takes it for 0.
real lane_log(real x) {
    const natural e = log_exponent(x);
    const real y = log_sum(e, log_series(as_real(as_natural(x) - e) - 1.0f));
    const real finite = pick(x > 0.0f, y, pick(x < 0.0f, (real)(NAN), (real)(-INFINITY)));
    return pick(x < INFINITY, finite, x);
}

// log(1 + x) for x in (-1, inf], within 2 ulp; NaN gives NaN. The exponent is that of 1 + x rounded, but x goes into the
// series unrounded, as x 2^-e + (2^-e - 1): a tiny x keeps its digits. (0x40800000 - e is 4 2^-e: 2^-128 is no normal float.)
real lane_log1p(real x) {
    const natural e = log_exponent(1.0f + x);
    const real scale = as_real(0x40800000u - e);
    const real m = as_real(as_natural(x) - e) + fma(scale, (real)(0.25f), (real)(-1.0f));
    return pick(x < INFINITY, log_sum(e, log_series(m)), x);
}

// exp(x) = 2^n (1 + p): returns p in [-.3, .42], n goes to *exponent in the place of a float's. Adding 1.5 2^23 rounds to
// an integer and leaves it in the lowest bits. log(2) in two parts (the first with 15 bits: n times it is exact), p's
// relative error 1.4e-8 before rounding. |x| < 2^21, else meaningless.
real exp_reduced(real x, natural *exponent) {
    const real shifted = fma(x, (real)(0x1.715476p+0f), (real)(0x1.8p+23f)), n = shifted - 0x1.8p+23f;
    const real r = fma(n, (real)(-0x1.7f7d1cp-20f), fma(n, (real)(-0x1.62e4p-1f), x)), s = r * r;
    const real a = fma(r, (real)(0.166665465f), (real)(0.49999997f));
    const real b = fma(r, (real)(0.0083662523f), (real)(0.0416674428f));
    *exponent = as_natural(shifted) << 23u;
    return fma(s, fma(s, fma(s, (real)(0.00138699636f), b), a), r);
}

// First float whose exponential is above FLT_MAX.
#define EXP_OVERFLOW 0x1.62e43p+6f

// Within 1.1 ulp. Below FLT_MIN the result is 0, above FLT_MAX inf; NaN gives NaN.
real lane_exp(real x) {
    natural exponent;
    const real p = exp_reduced(x, &exponent);
    const real y = pick(x >= -0x1.5d589ep+6f, as_real(as_natural(1.0f + p) + exponent), (real)(0.0f));
    return pick(x < EXP_OVERFLOW, y, x + INFINITY);
}

// exp(x) - 1 = 2^n p + (2^n - 1), within 1.7 ulp; above FLT_MAX inf; NaN gives NaN. Halves, as 2^128 is no float. -17.5 and
// what is below give -1, the nearest float.
real lane_expm1(real x) {
    natural exponent;
    const real p = exp_reduced(x, &exponent);
    const real scale = as_real(exponent + 0x3f000000u), half_y = fma(p, scale, scale - 0.5f);
    return pick(x < EXP_OVERFLOW, pick(x > -17.5f, half_y + half_y, (real)(-1.0f)), x + INFINITY);
}

// One number through the same operations, where a path is alone: the same to the bit for any LANES.
float exp_scalar(float x) {
    const real y = lane_exp((real)(x));
    return LANE_FLOAT(y, 0u);
}

float expm1_scalar(float x) {
    const real y = lane_expm1((real)(x));
    return LANE_FLOAT(y, 0u);
}

float log_scalar(float x) {
    const real y = lane_log((real)(x));
    return LANE_FLOAT(y, 0u);
}

// sin and cos of 2 pi u for u in [0, 1]. Argument reduction is exact in turns, the number of quarters rounded as in
// exp_reduced, 2 pi in two parts; polynomials on [-pi/4, pi/4] from Moshier's Cephes (sinf, cosf): within 2 ulp. In place of
// sincos(), which takes a pointer. Once over scalars, for surfaces, and once over lanes where those are vectors.
#define DEFINE_SINCOS(name, R, W, AS_WHOLE, PICK)                                                                      \
    void name(R u, R *s, R *c) {                                                                                       \
        const R shifted = fma(u, (R)(4.0f), (R)(0x1.8p+23f)), quarter = shifted - 0x1.8p+23f;                          \
        const R turn = fma(quarter, (R)(-0.25f), u), rest = turn * -0x1.777a5cp-23f;                                   \
        const R r = fma(turn, (R)(0x1.921fb6p+2f), rest);                                                              \
        const W k = AS_WHOLE(shifted);                                                                                 \
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
DEFINE_SINCOS(sincos_scalar, float, int, as_int, SCALAR_PICK)
#if LANES == 1
#define sincos_turns sincos_scalar
#else
DEFINE_SINCOS(sincos_turns, real, whole, as_whole, pick)
#endif

#endif
