// Same bits on every device (--exact). OpenCL leaves the last bits of many built-ins to the implementation; with EXACT these take
// the place of those that the renderer uses. What is left, +, -, *, /, sqrt, fma, comparisons and conversions, rounds in one way
// only (quotients and roots because the host asks for it, see device/exact.h); fma is never made by contraction; elementary
// functions are our own on every device (lanes/math.h, lanes/scalar.h). It comes before all else in a program.
#ifndef NACRE_EXACT_BUILTINS_H
#define NACRE_EXACT_BUILTINS_H

#ifdef EXACT

#pragma OPENCL FP_CONTRACT OFF

float exact_dot(float3 a, float3 b) { return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z)); }

float3 exact_cross(float3 a, float3 b) {
    return (float3)(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

// PoCL has them as macros.
#undef dot
#undef cross
#undef mix
#define dot(a, b) exact_dot(a, b)
#define cross(a, b) exact_cross(a, b)
#define mix(a, b, t) ((a) + ((b) - (a)) * (t))

#endif

#endif
