// The techniques that follow the medium's slowest mode.
#ifndef NACRE_GUIDE_EIGEN_H
#define NACRE_GUIDE_EIGEN_H

#include "guide/guide.h"

// In a turn a walk tries so often to find a direction before it waits for the next, while other lanes compute along.
#ifndef EIGEN_TRIES
#define EIGEN_TRIES 2u
#endif

typedef struct {
    Sides x, y, z;
} ChannelSides;

// phi of each channel at a cosine.
ChannelSides eigen_phi(const Scene *scene, const GuideLanes *guide, real mu) {
    ChannelSides phi;
    if (!HAS(ANISOTROPY)) {
        phi.x = isotropic_sides(&guide->x, mu);
        phi.y = isotropic_sides(&guide->y, mu);
        phi.z = isotropic_sides(&guide->z, mu);
        return phi;
    }
    phi.x = polynomial_sides(&guide->x.phi, mu);
    phi.y = polynomial_sides(&guide->y.phi, mu);
    phi.z = polynomial_sides(&guide->z.phi, mu);
    return phi;
}

// The mean of phi after a scatter from there.
ChannelSides eigen_scattered(const Scene *scene, const GuideLanes *guide, real mu) {
    ChannelSides mean;
    if (!HAS(ANISOTROPY)) {
        mean.x.near = mean.x.far = (real)(1.0f);
        mean.y = mean.z = mean.x;
        return mean;
    }
    mean.x = polynomial_sides(&guide->x.scattered, mu);
    mean.y = polynomial_sides(&guide->y.scattered, mu);
    mean.z = polynomial_sides(&guide->z.scattered, mu);
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

// Turns the direction `from` of the lanes `turning` by the technique that was chosen; phi: at each lane's new direction, or at
// the one that it keeps. Returns the lanes whose direction was refused: one of the phase function is kept with the
// probability phi / peak. Isotropic scattering refuses none.
mask eigen_try(const Scene *scene, GuideLanes *guide, whole channel, real g, mask turning, LaneSampler sampler, real3 from,
               real3 *direction, ChannelSides *phi) {
    const Natural4 words = lane_draw(sampler, DRAW_WALK_TRY, guide->tries);
    DirectionNumbers numbers;
    numbers.cosine = lane_unit(words.x);
    numbers.azimuth = lane_unit(words.y);
    const mask classical = guide->technique == TECHNIQUE_CLASSICAL;
    real3 tried = phase_sample(scene, g, numbers.cosine, numbers.azimuth, from);
    if (!HAS(ANISOTROPY)) tried = pick3(classical, tried, isotropic_towards(guide, guide->technique, channel, numbers));
    *direction = pick3(turning, tried, *direction);
    guide->tries += pick(turning, (natural)(1u), (natural)(0u));
    *phi = eigen_phi(scene, guide, dot3(guide->outward, *direction));
    if (!HAS(ANISOTROPY)) return (mask)(0);
    const real near = channel_of(phi->x.near, phi->y.near, phi->z.near, channel);
    const real far = channel_of(phi->x.far, phi->y.far, phi->z.far, channel);
    const real peak = channel_of(guide->x.peak, guide->y.peak, guide->z.peak, channel);
    const mask refused = lane_unit(words.z) * peak >= pick(guide->technique == TECHNIQUE_FAR, far, near);
    return turning & (classical == 0) & refused;
}

// Tries so often in one turn. Returns the lanes of `active` that have got no direction; they keep theirs.
uint eigen_turn(const Scene *scene, GuideLanes *guide, whole channel, real g, mask entering, LaneSampler sampler, uint active,
                real3 *direction, ChannelSides *phi) {
    const real3 from = *direction;
    mask turning = entering == 0;
    for (uint i = 0u; i < EIGEN_TRIES; i++) {
        turning = eigen_try(scene, guide, channel, g, turning, sampler, from, direction, phi);
        if ((bits(turning) & active) == 0u) break;
    }
    *direction = pick3(turning, from, *direction);
    return bits(turning) & active;
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
    const real before = dot3(guide->outward, *direction);
    ChannelSides promise = eigen_scattered(scene, guide, before);
    if ((bits(entering) & active) != 0u) promise = pick_channel_sides(entering, eigen_phi(scene, guide, before), promise);
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
