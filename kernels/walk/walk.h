// The random walk inside a medium with RGB extinction: what one flight does to position, direction and weights.
// Where the flight ends is the caller's business (a mesh, or a plane in the probes).
//
// Chromatic weights by the one-sample balance heuristic (physics: memo eqs 2-4, with the sum over wavelengths and the pdfs
// that it leaves out): W_c *= f_c / sum_l P_l p_l, with f_c = albedo_c p_c for a scatter and the transmittance for the exit.
// P is set by the channel sampling:
//     single      one channel for the whole walk, the others carry nothing (memo Fig 2, left)
//     albedo      P proportional to the albedo (Fig 2, centre)
//     throughput  P proportional to W (Fig 2, right)
//     hero        P proportional to the product of channel c's pdfs so far: one channel drawn per walk, balance over walks
// The phase function is the same for all channels and cancels.
#ifndef NACRE_WALK_WALK_H
#define NACRE_WALK_WALK_H

#include "flight/flight.h"
#include "phase/henyey_greenstein.h"

// Walks whose largest weight is below this play Russian roulette; survivors are raised to it.
#ifndef WALK_ROULETTE
#define WALK_ROULETTE 0.1f
#endif

typedef struct {
    real3 position, direction;
    real3 weight;  // W_c
    real3 share;   // P_c
    real3 sigma, albedo;
    real anisotropy, bleed;
    mask reciprocal; // flight law
    whole channel;   // drawn for the next flight: 0, 1, 2
    real first_number;
    natural steps;   // scatters so far
} Walk;

real3 real3_of(float3 v) {
    real3 r;
    r.x = (real)(v.x);
    r.y = (real)(v.y);
    r.z = (real)(v.z);
    return r;
}

real3 triple(real x) {
    real3 r;
    r.x = x;
    r.y = x;
    r.z = x;
    return r;
}

real largest(real3 v) { return max(v.x, max(v.y, v.z)); }

whole choose_channel(real3 share, real xi) {
    return pick(xi < share.x, (whole)(0), pick(xi < share.x + share.y, (whole)(1), (whole)(2)));
}

real channel_of(real3 v, whole channel) { return pick(channel == 0, v.x, pick(channel == 1, v.y, v.z)); }

real3 normalised(real3 v) {
    const real scale = 1.0f / (v.x + v.y + v.z);
    real3 r;
    r.x = v.x * scale;
    r.y = v.y * scale;
    r.z = v.z * scale;
    return r;
}

// Weights, shares and channel at the entry. xi in (0, 1) draws the channel.
typedef struct {
    float3 weight, share;
    uint channel;
} WalkStart;

WalkStart walk_start(const Scene *scene, float xi) {
    WalkStart start;
    start.channel = min((uint)(xi * 3.0f), 2u);
    start.weight = (float3)(1.0f);
    start.share = (float3)(1.0f / 3.0f);
    if (scene->frame->channel_sampling == CHANNEL_SINGLE) {
        start.share = (float3)(start.channel == 0u, start.channel == 1u, start.channel == 2u);
        start.weight = 3.0f * start.share;
    }
    return start;
}

void walk_begin(Walk *walk, WalkStart start) {
    walk->steps = (natural)(0);
    walk->channel = (whole)((int)start.channel);
    walk->weight = real3_of(start.weight);
    walk->share = real3_of(start.share);
}

// The modes that draw a channel for every flight do it in walk_choose, before the flight.
bool walk_chooses(const Scene *scene) {
    return scene->frame->channel_sampling == CHANNEL_ALBEDO || scene->frame->channel_sampling == CHANNEL_THROUGHPUT;
}

void walk_choose(const Scene *scene, Walk *walk, real xi) {
    real3 share = scene->frame->channel_sampling == CHANNEL_ALBEDO ? walk->albedo : walk->weight;
    share.x += 1e-30f; // a black medium: any channel will do
    share.y += 1e-30f;
    share.z += 1e-30f;
    walk->share = normalised(share);
    walk->channel = choose_channel(walk->share, xi);
}

Flight walk_flight(const Walk *walk) { return flight_of(walk->bleed, walk->reciprocal, walk->steps > 0u); }

// Length of the next flight if nothing is in its way.
real walk_distance(const Scene *scene, const Walk *walk, real xi) {
    return flight_sample(scene, walk_flight(walk), xi) / channel_of(walk->sigma, walk->channel);
}

// Balance heuristic over channels: density of each channel's technique, and what is left of its light (the albedo, or 1).
void walk_weigh(const Scene *scene, Walk *walk, real3 density, real3 factor) {
    const real mixture =
        fma(walk->share.x, density.x, fma(walk->share.y, density.y, walk->share.z * density.z));
    const real inverse = 1.0f / mixture;
    density.x *= inverse;
    density.y *= inverse;
    density.z *= inverse;
    walk->weight.x *= factor.x * density.x;
    walk->weight.y *= factor.y * density.y;
    walk->weight.z *= factor.z * density.z;
    if (scene->frame->channel_sampling == CHANNEL_HERO) {
        walk->share.x *= density.x;
        walk->share.y *= density.y;
        walk->share.z *= density.z;
    }
}

// The flight ended after `distance`: at the surface where `left`, else in a scatter, from where it goes on in a new direction.
// xi_cosine, xi_azimuth in (0, 1).
void walk_arrive(const Scene *scene, Walk *walk, real distance, mask left, real xi_cosine, real xi_azimuth) {
    const Flight flight = walk_flight(walk);
    const real one = (real)(1.0f);
    real3 density, factor;
    density.x = flight_density(scene, flight, walk->sigma.x * distance, left) * pick(left, one, walk->sigma.x);
    density.y = flight_density(scene, flight, walk->sigma.y * distance, left) * pick(left, one, walk->sigma.y);
    density.z = flight_density(scene, flight, walk->sigma.z * distance, left) * pick(left, one, walk->sigma.z);
    factor.x = pick(left, one, walk->albedo.x);
    factor.y = pick(left, one, walk->albedo.y);
    factor.z = pick(left, one, walk->albedo.z);
    walk_weigh(scene, walk, density, factor);
    walk->position.x = fma(walk->direction.x, distance, walk->position.x);
    walk->position.y = fma(walk->direction.y, distance, walk->position.y);
    walk->position.z = fma(walk->direction.z, distance, walk->position.z);
    walk->direction = phase_sample(scene, walk->anisotropy, xi_cosine, xi_azimuth, walk->direction);
    walk->steps += pick(left, (natural)(0), (natural)(1));
}

// Russian roulette on the largest weight, never on the drawn channel's. Returns who survives: no NaN does, so that every
// walk ends. Those that `left` do not play.
mask walk_roulette(Walk *walk, real xi, mask left) {
    const real sum = walk->weight.x + walk->weight.y + walk->weight.z;
    const real heaviest = pick(sum >= 0.0f, largest(walk->weight), (real)(-1.0f));
    const mask survives = (xi * WALK_ROULETTE < heaviest) | left;
    const real scale = pick((heaviest < WALK_ROULETTE) & survives & (left == 0), WALK_ROULETTE / heaviest, (real)(1.0f));
    walk->weight.x *= scale;
    walk->weight.y *= scale;
    walk->weight.z *= scale;
    return survives;
}

#endif
