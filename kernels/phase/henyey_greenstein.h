// Henyey & Greenstein 1941 (memo eq 5), in a form that keeps its digits for every g in (-1, 1), g -> 0 and g -> 1
// included: with u = 2 xi - 1 and h = |g|
//     1 - cos = (1-h)^2 (1-u)(1 + h(1+u)/2) / (1+hu)^2      1 + cos = (1+h)^2 (1+u)(1 - h(1-u)/2) / (1+hu)^2
// (mirrored for g < 0), absolute error 4e-7; the textbook form divides by g.
#ifndef NACRE_PHASE_HENYEY_GREENSTEIN_H
#define NACRE_PHASE_HENYEY_GREENSTEIN_H

#include "lanes/math.h"
#include "sampling/frame.h"
#include "shared/view.h"

// Sine and cosine of the angle of deflection.
void phase_angle(real g, real xi, real *sine, real *cosine) {
    const real h = fabs(g), u = fma(xi, (real)(2.0f), (real)(-1.0f));
    const real d = fma(h, u, (real)(1.0f)), scale = 1.0f / (d * d);
    const real away = (1.0f - h) * (1.0f - h) * (1.0f - u) * fma(h, 0.5f * (1.0f + u), (real)(1.0f)) * scale;
    const real along = (1.0f + h) * (1.0f + h) * (1.0f + u) * fma(-h, 0.5f * (1.0f - u), (real)(1.0f)) * scale;
    *sine = sqrt(away * along);
    *cosine = copysign((real)(1.0f), g) * pick(away < along, 1.0f - away, along - 1.0f);
}

// A new direction after a scatter; xi_cosine and xi_azimuth in (0, 1).
real3 phase_sample(const Scene *scene, real g, real xi_cosine, real xi_azimuth, real3 direction) {
    real s, c;
    sincos_turns(xi_azimuth, &s, &c);
    if (!HAS(ANISOTROPY)) { // isotropic: the old direction does not matter
        const real sine = 2.0f * sqrt(xi_cosine * (1.0f - xi_cosine));
        real3 d;
        d.x = sine * c;
        d.y = sine * s;
        d.z = fma(xi_cosine, (real)(2.0f), (real)(-1.0f));
        return d;
    }
    real sine, cosine;
    phase_angle(g, xi_cosine, &sine, &cosine);
    return turn(direction, sine, cosine, s, c);
}

// Density per steradian. 1 - cos from the difference of the directions, never 1 - dot: exact for g near 1.
real phase_pdf(const Scene *scene, real g, real3 direction, real3 scattered) {
    if (!HAS(ANISOTROPY)) return (real)(0.25f * INV_PI);
    const real x = scattered.x - direction.x, y = scattered.y - direction.y, z = scattered.z - direction.z;
    const real away = 0.5f * fma(x, x, fma(y, y, z * z));
    const real d = fma(2.0f * g, away, (1.0f - g) * (1.0f - g));
    return 0.25f * INV_PI * (1.0f - g) * (1.0f + g) / (d * sqrt(d));
}

#endif
