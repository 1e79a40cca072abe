// phi of a medium's slowest mode (shared/guide.h) over lanes, and its mean over the directions after a scatter. Where scattering
// is isotropic phi is 1 / (nu - mu) itself, of which a direction can be drawn at once.
#ifndef NACRE_GUIDE_MODE_H
#define NACRE_GUIDE_MODE_H

#include "lanes/math.h"
#include "shared/guide.h"

#pragma OPENCL FP_CONTRACT OFF

// One channel's mode. scattered[l] = g^l phi[l]: the mean over the phase function, of g.
typedef struct {
    real phi[GUIDE_TERMS], scattered[GUIDE_TERMS];
    real peak, inverse_nu, spread;
} ModeLanes;

typedef struct {
    real value[GUIDE_TERMS];
} Legendre;

// A function of mu at mu and at -mu: the near and the far side's.
typedef struct {
    real near, far;
} Sides;

// P_0 .. P_(GUIDE_TERMS - 1) at mu, by Bonnet's recursion.
Legendre legendre_at(real mu) {
    Legendre p;
    p.value[0] = (real)(1.0f);
    p.value[1] = mu;
#pragma unroll
    for (int l = 2; l < GUIDE_TERMS; l++)
        p.value[l] = fma(mu * p.value[l - 1], (real)((2.0f * l - 1.0f) / l), p.value[l - 2] * (real)(-(l - 1.0f) / l));
    return p;
}

// The sum of the polynomials at mu and at -mu: P_l is even or odd as l is.
Sides mode_sides(const real *factors, const Legendre *p) {
    real even = factors[0], odd = factors[1] * p->value[1];
#pragma unroll
    for (int l = 2; l < GUIDE_TERMS; l += 2) {
        even = fma(factors[l], p->value[l], even);
        odd = fma(factors[l + 1], p->value[l + 1], odd);
    }
    Sides sides;
    sides.near = even + odd;
    sides.far = even - odd;
    return sides;
}

// Cosine towards the side, density 1 / (spread (nu - mu)): mu = nu - (nu + 1) exp(-xi spread), in a form that keeps its
// digits for a large nu.
real isotropic_cosine(real inverse_nu, real spread, real xi) {
    const real nu = 1.0f / inverse_nu, e = -xi * spread;
    return max((real)(-1.0f), min(-nu * lane_expm1(e) - lane_exp(e), (real)(1.0f)));
}

// Of that cosine, per steradian.
real isotropic_pdf(const ModeLanes *mode, real mu) {
    return mode->inverse_nu * (0.5f * INV_PI) / (mode->spread * (1.0f - mode->inverse_nu * mu));
}

#endif
