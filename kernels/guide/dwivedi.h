// The memo's techniques: Krivanek & d'Eon 2014 towards either side, their direction whatever the phase function says.
#ifndef NACRE_GUIDE_DWIVEDI_H
#define NACRE_GUIDE_DWIVEDI_H

#include "guide/guide.h"

Sides dwivedi_shares(real share, real far_strength) {
    Sides shares;
    shares.near = share / (1.0f + far_strength);
    shares.far = share - shares.near;
    return shares;
}

void dwivedi_flight(GuidedFlight *flight, real share, const ModeLanes *mode, Sides shares, real mu, real inverse_phase,
                    mask entering) {
    flight->near = shares.near;
    flight->far = shares.far;
    const Sides sides = isotropic_sides(mode, mu);
    const real guided = (0.25f * INV_PI) * fma(shares.near, sides.near, shares.far * sides.far);
    flight->direction = pick(entering, (real)(1.0f), fma(guided, inverse_phase, 1.0f - share));
    flight->tilt = mu * mode->inverse_nu;
}

// As eigen_direct, but for two numbers: xi_technique draws the technique of the direction, xi_length that of the length. No
// lane waits.
void dwivedi_direct(const Scene *scene, GuideLanes *guide, real3 sigma, real3 position, Flight flight, whole channel, real3 g,
                    mask entering, real xi_technique, real xi_length, DirectionNumbers numbers, real3 *direction) {
    const real3 far = guide_far_strength(scene, guide, sigma, position, flight);
    const Sides shares_x = dwivedi_shares(guide->share, far.x), shares_y = dwivedi_shares(guide->share, far.y),
                shares_z = dwivedi_shares(guide->share, far.z);
    const real near = channel_of(shares_x.near, shares_y.near, shares_z.near, channel);
    const whole technique = guide_technique(guide, near, xi_technique);
    guide->technique = guide_technique(guide, near, xi_length);

    const real3 from = *direction;
    const real3 guided = isotropic_towards(guide, technique, channel, numbers);
    const real3 classical = phase_sample(scene, channel_of(g.x, g.y, g.z, channel), numbers.cosine, numbers.azimuth, from);
    *direction = pick3(entering, from, pick3(technique == TECHNIQUE_CLASSICAL, classical, guided));

    const real mu = dot3(guide->outward, *direction);
    dwivedi_flight(&guide->flight_x, guide->share, &guide->x, shares_x, mu, 1.0f / phase_pdf(scene, g.x, from, *direction),
                   entering);
    dwivedi_flight(&guide->flight_y, guide->share, &guide->y, shares_y, mu, 1.0f / phase_pdf(scene, g.y, from, *direction),
                   entering);
    dwivedi_flight(&guide->flight_z, guide->share, &guide->z, shares_z, mu, 1.0f / phase_pdf(scene, g.z, from, *direction),
                   entering);
}

#endif
