// The techniques that follow the medium's slowest mode.
#ifndef NACRE_GUIDE_EIGEN_H
#define NACRE_GUIDE_EIGEN_H

#include "guide/guide.h"

typedef struct {
    Sides x, y, z;
} ChannelSides;

// phi of each channel at a cosine; `scattered`: its mean after a scatter from there.
ChannelSides eigen_phi(const GuideLanes *guide, const Legendre *at) {
    ChannelSides phi;
    phi.x = mode_sides(guide->x.phi, at);
    phi.y = mode_sides(guide->y.phi, at);
    phi.z = mode_sides(guide->z.phi, at);
    return phi;
}

ChannelSides eigen_scattered(const GuideLanes *guide, const Legendre *at) {
    ChannelSides mean;
    mean.x = mode_sides(guide->x.scattered, at);
    mean.y = mode_sides(guide->y.scattered, at);
    mean.z = mode_sides(guide->z.scattered, at);
    return mean;
}

Sides pick_sides(mask m, Sides a, Sides b) {
    Sides r;
    r.near = pick(m, a.near, b.near);
    r.far = pick(m, a.far, b.far);
    return r;
}

ChannelSides pick_channel_sides(mask m, ChannelSides a, ChannelSides b) {
    ChannelSides r;
    r.x = pick_sides(m, a.x, b.x);
    r.y = pick_sides(m, a.y, b.y);
    r.z = pick_sides(m, a.z, b.z);
    return r;
}

// Turns `direction` by the technique that was chosen: a direction of the phase function is kept with the probability phi /
// peak. Those `entering` keep the one they have. Returns the lanes of `active` whose direction was refused. phi: at the new
// direction.
uint eigen_turn(const Scene *scene, GuideLanes *guide, whole channel, real g, mask entering, LaneSampler sampler, uint active,
                real3 *direction, ChannelSides *phi) {
    const Natural4 words = lane_draw(sampler, DRAW_WALK_TRY, guide->tries);
    const real3 from = *direction;
    const real3 tried = pick3(entering, from, phase_sample(scene, g, lane_unit(words.x), lane_unit(words.y), from));
    const Legendre at = legendre_at(dot3(guide->outward, tried));
    *phi = eigen_phi(guide, &at);
    const real near = channel_of(phi->x.near, phi->y.near, phi->z.near, channel);
    const real far = channel_of(phi->x.far, phi->y.far, phi->z.far, channel);
    const real peak = channel_of(guide->x.peak, guide->y.peak, guide->z.peak, channel);
    const mask kept = entering | (guide->technique == TECHNIQUE_CLASSICAL) |
                      (lane_unit(words.z) * peak < pick(guide->technique == TECHNIQUE_FAR, far, near));
    *direction = pick3(kept, tried, from);
    guide->tries += (natural)(1u);
    return active & ~bits(kept);
}

// Share per promise of a channel: the sides' shares are their promises, the far one's times `far_strength`, times this.
real eigen_scale(real share, Sides promise, real far_strength) {
    return share / fma(far_strength, promise.far, promise.near);
}

void eigen_flight(GuidedFlight *flight, const ModeLanes *mode, real mu, Sides phi, real far_strength, real scale) {
    flight->near = phi.near * scale;
    flight->far = far_strength * phi.far * scale;
    flight->direction = (real)(1.0f);
    flight->tilt = mu * mode->inverse_nu;
}

// Chooses a technique for the next flight of the channels drawn, turns its direction, and prepares its density. Returns the
// lanes of `active` that have to wait.
uint eigen_direct(const Scene *scene, GuideLanes *guide, real3 sigma, real3 position, Flight flight, whole channel, real g,
                  mask entering, real xi_technique, LaneSampler sampler, uint active, real3 *direction) {
    // What the sides promise: a scatter from the direction so far, or to those who enter a flight in it.
    const Legendre from = legendre_at(dot3(guide->outward, *direction));
    ChannelSides promise = eigen_scattered(guide, &from);
    if ((bits(entering) & active) != 0u) promise = pick_channel_sides(entering, eigen_phi(guide, &from), promise);
    const real3 far = guide_far_strength(scene, guide, sigma, position, flight);
    const real scale_x = eigen_scale(guide->share, promise.x, far.x), scale_y = eigen_scale(guide->share, promise.y, far.y),
               scale_z = eigen_scale(guide->share, promise.z, far.z);
    guide->technique = guide_technique(
        guide, channel_of(promise.x.near * scale_x, promise.y.near * scale_y, promise.z.near * scale_z, channel),
        xi_technique);
    ChannelSides phi;
    const uint refused = eigen_turn(scene, guide, channel, g, entering, sampler, active, direction, &phi);
    const real mu = dot3(guide->outward, *direction);
    eigen_flight(&guide->flight_x, &guide->x, mu, phi.x, far.x, scale_x);
    eigen_flight(&guide->flight_y, &guide->y, mu, phi.y, far.y, scale_y);
    eigen_flight(&guide->flight_z, &guide->z, mu, phi.z, far.z, scale_z);
    return refused;
}

#endif
