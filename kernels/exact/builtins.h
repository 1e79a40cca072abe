// Same bits on every device (--exact). OpenCL leaves the last bits of many built-ins to the implementation; with EXACT these take
// the place of those that the renderer uses. What is left, +, -, *, /, sqrt, fma, comparisons and conversions, rounds in one way
// only (quotients and roots because the host asks for it, see device/exact.h); fma is never made by contraction; what lanes
// compute has always been our own (lanes/math.h). It comes before all else in a program.
#ifndef NACRE_EXACT_BUILTINS_H
#define NACRE_EXACT_BUILTINS_H

#include "lanes/math.h"

#ifdef EXACT

#pragma OPENCL FP_CONTRACT OFF

float exact_dot(float3 a, float3 b) { return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z)); }

float3 exact_cross(float3 a, float3 b) {
    return (float3)(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

float exact_largest(float3 v) { return fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z))); }

// As the built-ins: squares neither overflow nor vanish. 0 has length 0 and stays 0.
float exact_length(float3 v) {
    const float scale = exact_largest(v);
    if (!(scale > 0.0f)) return scale;
    const float3 u = v / scale;
    return scale * sqrt(exact_dot(u, u));
}

float3 exact_normalize(float3 v) {
    const float scale = exact_largest(v);
    if (!(scale > 0.0f)) return v;
    const float3 u = v / scale;
    return u / sqrt(exact_dot(u, u));
}

// Within 3 ulp; atan on [0, tan(pi/8)] from Moshier's Cephes (atanf). 0 for 0, 0.
float exact_atan2(float y, float x) {
    const float ax = fabs(x), ay = fabs(y), larger = fmax(ax, ay);
    if (!(larger > 0.0f)) return 0.0f;
    const float ratio = fmin(ax, ay) / larger;
    const bool steep = ratio > 0.414213562f;
    const float t = steep ? (ratio - 1.0f) / (ratio + 1.0f) : ratio, t2 = t * t;
    const float p = fma(t2, fma(t2, fma(t2, 8.05374449538e-2f, -1.38776856032e-1f), 1.99777106478e-1f), -3.33329491539e-1f);
    float angle = fma(t * t2, p, t);
    if (steep) angle += 0.785398163f;
    if (ay > ax) angle = 1.57079633f - angle;
    if (x < 0.0f) angle = 3.14159265f - angle;
    return copysign(angle, y);
}

// Of v in [0, 2].
float exact_sinpi(float v) {
    float s, c;
    sincos_scalar(0.5f * v, &s, &c);
    return s;
}

float exact_cospi(float v) {
    float s, c;
    sincos_scalar(0.5f * v, &s, &c);
    return c;
}

// PoCL has them as macros.
#undef dot
#undef cross
#undef length
#undef normalize
#undef atan2
#undef sinpi
#undef cospi
#undef mix
#undef rsqrt
#define dot(a, b) exact_dot(a, b)
#define cross(a, b) exact_cross(a, b)
#define length(v) exact_length(v)
#define normalize(v) exact_normalize(v)
#define atan2(y, x) exact_atan2(y, x)
#define sinpi(v) exact_sinpi(v)
#define cospi(v) exact_cospi(v)
#define mix(a, b, t) ((a) + ((b) - (a)) * (t))
#define rsqrt(x) (1.0f / sqrt(x))

#endif

#endif
