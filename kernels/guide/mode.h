// phi of a medium's slowest mode (shared/guide.h) over lanes, and its mean over the directions after a scatter. Where scattering
// is isotropic phi is 1 / (nu - mu) itself, of which a direction can be drawn at once.
#ifndef NACRE_GUIDE_MODE_H
#define NACRE_GUIDE_MODE_H

#include "lanes/math.h"
#include "shared/guide.h"

#pragma OPENCL FP_CONTRACT OFF

#if GUIDE_TERMS != 8
#error "polynomial_load has the first eight Legendre polynomials"
#endif

// A polynomial in mu: even[k] mu^(2k) + odd[k] mu^(2k + 1). A sum of Legendre polynomials takes half as many operations in this
// form as by their recursion, and of so few it is as exact as phi asks for.
typedef struct {
    real even[GUIDE_TERMS / 2], odd[GUIDE_TERMS / 2];
} Polynomial;

// One channel's mode. `scattered` is the mean of phi over the phase function of g, whose P_l are g^l times phi's. Isotropic media
// have neither, nor a peak.
typedef struct {
    Polynomial phi, scattered;
    real peak, inverse_nu, spread;
} ModeLanes;

// A function of mu at mu and at -mu: the near and the far side's.
typedef struct {
    real near, far;
} Sides;

// Puts the sum of factors[l] P_l into lane l of a polynomial.
void polynomial_load(Polynomial *lanes, uint l, const float *factors) {
    const float4 even = factors[0] * (float4)(1.0f, 0.0f, 0.0f, 0.0f) + factors[2] * (float4)(-0.5f, 1.5f, 0.0f, 0.0f) +
                        factors[4] * (float4)(0.375f, -3.75f, 4.375f, 0.0f) +
                        factors[6] * (float4)(-0.3125f, 6.5625f, -19.6875f, 14.4375f);
    const float4 odd = factors[1] * (float4)(1.0f, 0.0f, 0.0f, 0.0f) + factors[3] * (float4)(-1.5f, 2.5f, 0.0f, 0.0f) +
                       factors[5] * (float4)(1.875f, -8.75f, 7.875f, 0.0f) +
                       factors[7] * (float4)(-2.1875f, 19.6875f, -43.3125f, 26.8125f);
    LANE_FLOAT(lanes->even[0], l) = even.x;
    LANE_FLOAT(lanes->even[1], l) = even.y;
    LANE_FLOAT(lanes->even[2], l) = even.z;
    LANE_FLOAT(lanes->even[3], l) = even.w;
    LANE_FLOAT(lanes->odd[0], l) = odd.x;
    LANE_FLOAT(lanes->odd[1], l) = odd.y;
    LANE_FLOAT(lanes->odd[2], l) = odd.z;
    LANE_FLOAT(lanes->odd[3], l) = odd.w;
}

Sides polynomial_sides(const Polynomial *p, real mu) {
    const real square = mu * mu;
    const real even = fma(square, fma(square, fma(square, p->even[3], p->even[2]), p->even[1]), p->even[0]);
    const real odd = mu * fma(square, fma(square, fma(square, p->odd[3], p->odd[2]), p->odd[1]), p->odd[0]);
    Sides sides;
    sides.near = even + odd;
    sides.far = even - odd;
    return sides;
}

// Cosine towards the side, density 1 / (spread (nu - mu)): mu = nu - (nu + 1) exp(-xi spread), in a form that keeps its
// digits for a large nu.
real isotropic_cosine(real inverse_nu, real spread, real xi) {
    const real nu = 1.0f / inverse_nu, m = lane_expm1(-xi * spread);
    return max((real)(-1.0f), min(-nu * m - (1.0f + m), (real)(1.0f)));
}

// The density of that cosine, per steradian, over that of isotropic scattering.
Sides isotropic_sides(const ModeLanes *mode, real mu) {
    const real tilt = mode->inverse_nu * mu, near = 1.0f - tilt, far = 1.0f + tilt;
    const real scale = 2.0f * mode->inverse_nu / (mode->spread * near * far);
    Sides sides;
    sides.near = scale * far;
    sides.far = scale * near;
    return sides;
}

#endif
