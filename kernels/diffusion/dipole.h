// The two dipoles: shape of the light that leaves a half-space after multiple scattering, its total, and the albedo that shows
// a colour. Lengths are in units of the real source's depth, 1 / sigma_t', sigma_t' = sigma_t (1 - albedo g); s^2 = 1 - alpha',
// alpha' the reduced albedo. The refractive interface is left out, as in the random walk (relative index 1: A = 1).
//     dipole         Jensen, Marschner, Levoy, Hanrahan 2001, "A Practical Model for Subsurface Light Transport", section 2.3:
//                    D = 1/3, sources at depth 1 and above the surface at 1 + 4 A D, R from the flux through the surface
//     better_dipole  d'Eon 2012, "A Better Dipole": Grosjean's D = (2 - alpha') / 3, R = C_E flux + C_phi fluence with
//                    C_E = 1/2, C_phi = 1/4 at relative index 1, times alpha'^2: light that scattered twice or more
//
// What a flat half-space shows. Neither formula knows what the other lobes bring:
//     zero       light that goes straight through: none there, e^(-sigma t) where a body is thin
//     single     albedo c1(g), c1 = (2/3)(1 - ln 2) = .2046 at g = 0, the exact single scattering
//     multiple   the dipole's total, up to 1 at albedo 1
// The colour asked for is single + multiple; dipole_depth finds the albedo for it. At albedo 1 the sum would be 1 + c1(g): both
// formulas overshoot (diffusion counts light twice), so white is reached at a lower albedo (.9939 and .9943 at g = 0).
// Hery 2012, "Texture Mapping for the Better Dipole Model", inverts the multiple lobe alone.
#ifndef NACRE_DIFFUSION_DIPOLE_H
#define NACRE_DIFFUSION_DIPOLE_H

#include "lanes/math.h"
#include "lanes/scalar.h"
#include "shared/view.h"

typedef struct {
    float decay;   // sigma_tr / sigma_t'
    float image;   // height of the virtual source
    float fluence; // weight of the fluence beside the flux: C_phi / (C_E D)
} Dipole;

Dipole dipole_of(int model, float s) {
    Dipole dipole;
    if (model == MODEL_DIPOLE) {
        dipole.decay = 1.7320508f * s;
        dipole.image = 7.0f / 3.0f;
        dipole.fluence = 0.0f;
    } else {
        const float d = (1.0f + s * s) * (1.0f / 3.0f);
        dipole.decay = s / sqrt(d);
        dipole.image = 1.0f + 4.0f * d;
        dipole.fluence = 0.5f / d;
    }
    return dipole;
}

// Integrals over the plane, divided by 2 pi: of the flux (1 + k d) e^(-kd) z / d^3 of a source at distance d from its foot at
// depth z, and of both sources' fluence e^(-kd) / d.
float dipole_flux(float decay, float depth) { return exp_scalar(-decay * depth); }

float dipole_mass(Dipole dipole) {
    const float k = max(1e-6f, dipole.decay); // the limit k -> 0 to 1e-6
    const float fluence = -exp_scalar(-k) * expm1_scalar(-k * (dipole.image - 1.0f)) / k;
    return dipole_flux(dipole.decay, 1.0f) + dipole_flux(dipole.decay, dipole.image) + dipole.fluence * fluence;
}

// Total of the multiple lobe.
float dipole_total(int model, float s) {
    const float albedo = (1.0f - s) * (1.0f + s);
    return dipole_mass(dipole_of(model, s)) * albedo * (model == MODEL_DIPOLE ? 0.5f : 0.25f * albedo);
}

// Share of cosine-weighted light that leaves a half-space after one scatter, per unit of albedo. A fit to the integral over
// entry and exit cosines of 2 mu mu' / (mu + mu') p(mu, -mu'), p Henyey-Greenstein's average over the azimuth: within 6e-5
// for |g| <= .995.
float single_scattering(float g) {
    float c = fma(g, -0.012608573f, -0.0036607268f);
    c = fma(g, c, 0.013268474f);
    c = fma(g, c, 0.0073065726f);
    c = fma(g, c, -0.0083436128f);
    c = fma(g, c, 0.0071123727f);
    c = fma(g, c, -0.026874453f);
    return (1.0f - g) * fma(g, c, 0.20461814f);
}

float dipole_albedo(float s, float g) { return (1.0f - s) * (1.0f + s) / (1.0f - g * s * s); }

// s of an albedo.
float dipole_similarity(float albedo, float g) { return sqrt((1.0f - albedo) / (1.0f - g * albedo)); }

// s of the half-space that shows `color` in [0, 1]. The sum of the lobes falls with s, to 0 at 1: halving, to 2^-24.
float dipole_inverse(int model, float color, float g) {
    const float single = single_scattering(g);
    float low = 0.0f, high = 1.0f;
    for (int i = 0; i < 24; ++i) {
        const float s = 0.5f * (low + high);
        const bool brighter = fma(dipole_albedo(s, g), single, dipole_total(model, s)) > color;
        low = brighter ? s : low;
        high = brighter ? high : s;
    }
    return high;
}

// Fluence of both sources, x from their foot: e^(-kr)/r - e^(-kv)/v, without the cancellation of far away.
float dipole_fluence(Dipole dipole, float real_distance, float image_distance) {
    const float apart = (dipole.image - 1.0f) * (dipole.image + 1.0f) / (real_distance + image_distance);
    const float lost = expm1_scalar(-dipole.decay * apart);
    return exp_scalar(-dipole.decay * real_distance) / real_distance *
           ((1.0f + lost) * apart / image_distance - lost);
}

// Flux of both sources, at distances r and v.
float dipole_sources(Dipole dipole, float r, float v) {
    const float k = dipole.decay;
    return fma(k, r, 1.0f) * exp_scalar(-k * r) / (r * r * r) +
           dipole.image * fma(k, v, 1.0f) * exp_scalar(-k * v) / (v * v * v);
}

// Distance from the foot of a source at `depth` with the density of its flux; xi in (0, 1). The share beyond the distance d from
// the source is depth e^(-k (d - depth)) / d: with d = depth e^w, w + k depth (e^w - 1) = -ln xi, convex, by Newton from above.
float dipole_radius(float decay, float depth, float xi) {
    const float wanted = -log_scalar(xi), k = decay * depth;
    float w = min(wanted, log_scalar(1.0f + wanted / max(1e-30f, k)));
    for (int i = 0; i < 5; ++i) {
        const float e = expm1_scalar(w);
        w = max(0.0f, w - (fma(k, e, w) - wanted) / fma(k, e + 1.0f, 1.0f));
    }
    return depth * sqrt(expm1_scalar(2.0f * w));
}

#endif
