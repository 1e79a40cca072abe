// Techniques that lead a walk to the surface: towards the near side, where it entered, or towards the far side. Of an object
// they see a slab, with the plane of the entry as its near side; where the object is none they are worse, never wrong.
//
// eigen: the walk follows the medium's slowest mode (shared/guide.h), exactly in the slab:
//     direction  HG(w_i . w) phi(mu) / Z(mu_i), Z the mean of phi after a scatter       distance  stretched by 1 / (1 - mu /
//     nu)
// dwivedi: Krivanek & d'Eon 2014, "A Zero-Variance-Based Sampling Scheme for Monte Carlo Subsurface Scattering", as in the
// memo's section 5: direction 1 / (2 pi spread (nu - mu)) about the side's normal, whatever the direction before; and
// direction and distance choose their technique apart. Each side's mode has the strength exp(-depth / nu) and its share of
// the light; the sides are chosen by what they promise. The far side is the near one with mu and mu_i turned round.
#ifndef NACRE_GUIDE_GUIDE_H
#define NACRE_GUIDE_GUIDE_H

#include "flight/flight.h"
#include "guide/mode.h"
#include "phase/henyey_greenstein.h"
#include "random/sampler.h"

#define GUIDED (HAS(GUIDE_EIGEN) || HAS(GUIDE_DWIVEDI))

// E-folds by which a side may be weaker than the other before it is none: 2e-9.
#define GUIDE_LEAST_FOLDS -20.0f

#define TECHNIQUE_CLASSICAL 0
#define TECHNIQUE_NEAR 1
#define TECHNIQUE_FAR 2

// One channel's part in the flight under way.
typedef struct {
    real near, far; // share of the side's technique, times its density of the direction over the classical one (eigen)
    real direction; // density of the direction over the classical one, where it was chosen apart (dwivedi)
    real tilt;      // mu / nu: the near side's technique stretches by 1 / (1 - tilt), the far side's by 1 / (1 + tilt)
} GuidedFlight;

typedef struct {
    real3 outward; // unit normal of the near side
    real offset;   // of its plane: a point's depth is offset - dot(outward, point)
    real thickness; // of the object below the triangle of the entry
    real share;     // of the guided techniques
    real far_light; // light on the far side over that on the near side
    ModeLanes x, y, z;
    natural tries; // directions that were tried so far
    // Of the flight under way:
    whole technique; // that draws its length
    bool has_far;    // some lane's may go to the far side
    GuidedFlight flight_x, flight_y, flight_z;
} GuideLanes;

// Numbers for a direction, in (0, 1).
typedef struct {
    real cosine, azimuth;
} DirectionNumbers;

// By how many e-folds a mode is stronger at the depth `near` below one side than at `far` below the other. Under bleed, which
// knows no exponential mode, it falls like the flights do.
real guide_folds(const Scene *scene, real near, real far, Flight flight) {
    if (!HAS(BLEED)) return near - far;
    return flight.rate * (flight_depth(scene, flight, near) - flight_depth(scene, flight, far));
}

// How strong the far side's mode is, for each channel, where the near side's is 1: by the depths of the position below both,
// and by the light on both. None where it is weakest: thick objects have no far side.
real3 guide_far_strength(const Scene *scene, GuideLanes *guide, real3 sigma, real3 position, Flight flight) {
    const real below = guide->offset - dot3(guide->outward, position);
    const real near = max(min(below, guide->thickness), (real)(0.0f)),
               far = guide->thickness - near; // beyond the slab: at its end
    const real rate_x = sigma.x * guide->x.inverse_nu, rate_y = sigma.y * guide->y.inverse_nu,
               rate_z = sigma.z * guide->z.inverse_nu;
    real3 folds;
    folds.x = guide_folds(scene, near * rate_x, far * rate_x, flight);
    folds.y = guide_folds(scene, near * rate_y, far * rate_y, flight);
    folds.z = guide_folds(scene, near * rate_z, far * rate_z, flight);
    const real least = (real)(GUIDE_LEAST_FOLDS), most = -least;
    guide->has_far = bits(largest(folds) > least) != 0u;
    real3 strength = triple((real)(0.0f));
    if (!guide->has_far) return strength;
    strength.x = pick(folds.x > least, guide->far_light * lane_exp(min(folds.x, most)), strength.x);
    strength.y = pick(folds.y > least, guide->far_light * lane_exp(min(folds.y, most)), strength.y);
    strength.z = pick(folds.z > least, guide->far_light * lane_exp(min(folds.z, most)), strength.z);
    return strength;
}

// How a flight in a given direction is stretched by a technique of one channel: 1 / the result. At least 1 / 2000, as nu is.
real guide_rate(whole technique, real tilt) {
    return pick(technique == TECHNIQUE_NEAR, 1.0f - tilt, pick(technique == TECHNIQUE_FAR, 1.0f + tilt, (real)(1.0f)));
}

// Which technique to take, where the near side's has the share `near`.
whole guide_technique(const GuideLanes *guide, real near, real xi) {
    return pick(xi < near, (whole)(TECHNIQUE_NEAR),
                pick(xi < guide->share, (whole)(TECHNIQUE_FAR), (whole)(TECHNIQUE_CLASSICAL)));
}

// A direction towards a technique's side by the mode of an isotropic medium, density isotropic_sides.
real3 isotropic_towards(const GuideLanes *guide, whole technique, whole channel, DirectionNumbers numbers) {
    const real inverse_nu = channel_of(guide->x.inverse_nu, guide->y.inverse_nu, guide->z.inverse_nu, channel);
    const real spread = channel_of(guide->x.spread, guide->y.spread, guide->z.spread, channel);
    const real side = pick(technique == TECHNIQUE_FAR, (real)(-1.0f), (real)(1.0f));
    const real cosine = side * isotropic_cosine(inverse_nu, spread, numbers.cosine);
    real s, c;
    sincos_turns(numbers.azimuth, &s, &c);
    return turn(guide->outward, sqrt(max(fma(-cosine, cosine, (real)(1.0f)), (real)(0.0f))), cosine, s, c);
}

// Density of one channel's flight after an optical depth tau, over all techniques, per unit of tau. `classical` is
// flight_density's.
real guided_density(const Scene *scene, const GuideLanes *guide, const GuidedFlight *guided, Flight flight, real tau,
                    real classical, mask left) {
    const real one = (real)(1.0f), near_rate = 1.0f - guided->tilt, far_rate = 1.0f + guided->tilt;
    const real near = pick(left, one, near_rate) * flight_density(scene, flight, near_rate * tau, left);
    real density = fma(guided->near, near, (1.0f - guide->share) * classical);
    if (guide->has_far) {
        const real far = pick(left, one, far_rate) * flight_density(scene, flight, far_rate * tau, left);
        density = fma(guided->far, far, density);
    }
    return guided->direction * density;
}

#endif
