// Directions about an axis.
#ifndef NACRE_SAMPLING_FRAME_H
#define NACRE_SAMPLING_FRAME_H

#include "lanes/lanes.h"

// Right-handed orthonormal basis (t, b, n) of a unit vector n. Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
void basis(float3 n, float3 *t, float3 *b) {
    const float s = copysign(1.0f, n.z);
    const float a = -1.0f / (s + n.z), c = n.x * n.y * a;
    *t = (float3)(fma(s * n.x * n.x, a, 1.0f), s * c, -s * n.x);
    *b = (float3)(c, fma(n.y * n.y, a, s), -n.y);
}

float3 to_world(float3 d, float3 n) {
    float3 t, b;
    basis(n, &t, &b);
    return d.x * t + d.y * b + d.z * n;
}

// The same over lanes: turns the unit vector n by a polar angle (sine, cosine) and an azimuth (sine, cosine).
real3 turn(real3 n, real sine, real cosine, real azimuth_sine, real azimuth_cosine) {
    const real s = copysign((real)(1.0f), n.z);
    const real a = -1.0f / (s + n.z), c = n.x * n.y * a;
    const real x = sine * azimuth_cosine, y = sine * azimuth_sine;
    real3 d;
    d.x = fma(x, fma(s * n.x * n.x, a, (real)(1.0f)), fma(y, c, cosine * n.x));
    d.y = fma(x, s * c, fma(y, fma(n.y * n.y, a, s), cosine * n.y));
    d.z = fma(x, -s * n.x, fma(y, -n.y, cosine * n.z));
    // Rounding would add up over the scatters of a walk. 1 / length to first order, as its square is 1 but for rounding: exact
    // to float, and without the root and the quotient that everything would wait for.
    const real inverse_length = fma(fma(d.x, d.x, fma(d.y, d.y, d.z * d.z)), (real)(-0.5f), (real)(1.5f));
    d.x *= inverse_length;
    d.y *= inverse_length;
    d.z *= inverse_length;
    return d;
}

#endif
