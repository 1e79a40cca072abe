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
// p is the density of direction and flight over all techniques (guide/guide.h) that draw them for channel c. The phase function
// cancels, unless it differs between the channels.
#ifndef NACRE_WALK_WALK_H
#define NACRE_WALK_WALK_H

#include "guide/dwivedi.h"
#include "guide/eigen.h"

// Walks whose largest weight is below this play Russian roulette; survivors are raised to it. In relative variance times time a
// slab of four mean free paths, lit from behind, where guided walks are dark, loses a fifth from .05 to .2 and half from there to
// .5, and gains nothing below .05; other guided bodies do not mind .02 to .2 (bench/error_time, modes roulette_*). Classical
// walks gain a fifth from .02 to .2, and little from there to .4.
#ifndef WALK_ROULETTE
#define WALK_ROULETTE (GUIDED ? 0.05f : 0.2f) // GUIDED asks `scene`
#endif

typedef struct {
    real3 position, direction;
    real3 weight;  // W_c
    real3 share;   // P_c
    real3 sigma, albedo;
    real3 anisotropy; // g of each channel; without ANISOTROPY_RGB all have x
    real3 phase;      // with it: phase functions of the last change of direction
    real bleed;
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

whole choose_channel(real3 share, real xi) {
    return pick(xi < share.x, (whole)(0), pick(xi < share.x + share.y, (whole)(1), (whole)(2)));
}

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

// What a dark channel's share in the draws has of a bright one's. Weights stay below 10: (2 + 3 x .3) / .3.
#define WALK_LEAST_SHARE 0.3f

// `color`: what the path brings back through each channel so far, the largest 1. Channels draw in proportion to it, and weights
// begin with it. `shown`: what the medium returns in each channel, about. With hero sampling, where a walk is the drawn channel's
// to its end, channels draw in proportion to that, too: in the bear relative variance is .75 times as much, in skin .95 times.
// Weights of one walk after the other do not multiply: by balance, each times its channel's factor, their sum stays what it is
// at the entry.
WalkStart walk_start(const Scene *scene, float3 color, float3 shown, float xi) {
    WalkStart start;
    const float brightest = max(shown.x, max(shown.y, shown.z));
    const bool hero = scene->frame->channel_sampling == CHANNEL_HERO && brightest > 0.0f;
    const float3 likely = hero ? color * (shown * (1.0f / brightest) + WALK_LEAST_SHARE) : color;
    const float sum = likely.x + likely.y + likely.z;
    start.weight = color;
    start.share = likely * (1.0f / sum);
    const bool second = xi < start.share.x + start.share.y || !(start.share.z > 0.0f); // else shares that round to less than 1
    start.channel = xi < start.share.x ? 0u : second ? 1u : 2u;
    if (scene->frame->channel_sampling == CHANNEL_SINGLE) {
        start.share = (float3)(start.channel == 0u, start.channel == 1u, start.channel == 2u);
        start.weight = sum * start.share;
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

real walk_anisotropy(const Scene *scene, const Walk *walk) {
    const real3 g = walk->anisotropy;
    return HAS(ANISOTROPY_RGB) ? channel_of(g.x, g.y, g.z, walk->channel) : g.x;
}

// The direction of the next flight: that of the entry, or a new one after a scatter. xi_technique and xi_length in (0, 1) choose the
// techniques. Returns the lanes of `active` that got none and have to wait for the next turn.
uint walk_direct(const Scene *scene, Walk *walk, GuideLanes *guide, real xi_technique, real xi_length, DirectionNumbers numbers,
                 LaneSampler sampler, uint active) {
    const mask entering = walk->steps == 0u;
    const real3 from = walk->direction;
    const real g = walk_anisotropy(scene, walk);
    uint waiting = 0u;
    if (HAS(GUIDE_EIGEN))
        waiting = eigen_direct(scene, guide, walk->sigma, walk->position, walk_flight(walk), walk->channel, g, entering, xi_technique, sampler,
                               active, &walk->direction);
    else if (HAS(GUIDE_DWIVEDI))
        dwivedi_direct(scene, guide, walk->sigma, walk->position, walk_flight(walk), walk->channel, walk->anisotropy, entering, xi_technique,
                       xi_length, numbers, &walk->direction);
    else
        walk->direction = pick3(entering, from, phase_sample(scene, g, numbers.cosine, numbers.azimuth, from));
    if (HAS(ANISOTROPY_RGB)) {
        const real one = (real)(1.0f);
        walk->phase.x = pick(entering, one, phase_pdf(scene, walk->anisotropy.x, from, walk->direction));
        walk->phase.y = pick(entering, one, phase_pdf(scene, walk->anisotropy.y, from, walk->direction));
        walk->phase.z = pick(entering, one, phase_pdf(scene, walk->anisotropy.z, from, walk->direction));
    }
    return waiting;
}

// Length of the next flight if nothing is in its way.
real walk_distance(const Scene *scene, const Walk *walk, const GuideLanes *guide, real xi) {
    const real3 sigma = walk->sigma;
    real rate = channel_of(sigma.x, sigma.y, sigma.z, walk->channel);
    if (GUIDED)
        rate *= guide_rate(guide->technique, channel_of(guide->flight_x.tilt, guide->flight_y.tilt, guide->flight_z.tilt,
                                                        walk->channel));
    return flight_sample(scene, walk_flight(walk), xi) / rate;
}

// Weights and shares of less are 0: nobody sees them, and left alone they become denormal numbers, which some processors are slow
// at: a half-space of skin took 1.2 (guided) to 1.4 times as long on an Intel Xeon.
#define WALK_LEAST 1e-20f

real walk_flushed(real x) { return pick(x < WALK_LEAST, (real)(0.0f), x); }

// Balance heuristic. `density` is the classical one of each channel, `mixed` that of all the channel's techniques, `factor` what
// is left of its light (the albedo, or 1).
void walk_weigh(const Scene *scene, Walk *walk, real3 density, real3 mixed, real3 factor) {
    const real mixture = fma(walk->share.x, mixed.x, fma(walk->share.y, mixed.y, walk->share.z * mixed.z));
    const real inverse = 1.0f / mixture;
    walk->weight.x = walk_flushed(walk->weight.x * (factor.x * (density.x * inverse)));
    walk->weight.y = walk_flushed(walk->weight.y * (factor.y * (density.y * inverse)));
    walk->weight.z = walk_flushed(walk->weight.z * (factor.z * (density.z * inverse)));
    if (scene->frame->channel_sampling == CHANNEL_HERO) {
        walk->share.x = walk_flushed(walk->share.x * (mixed.x * inverse));
        walk->share.y = walk_flushed(walk->share.y * (mixed.y * inverse));
        walk->share.z = walk_flushed(walk->share.z * (mixed.z * inverse));
    }
}

real3 product3(real3 a, real3 b) {
    real3 r;
    r.x = a.x * b.x;
    r.y = a.y * b.y;
    r.z = a.z * b.z;
    return r;
}

// The flight ended after `distance`: at the surface where `left`, else in a scatter.
void walk_arrive(const Scene *scene, Walk *walk, const GuideLanes *guide, real distance, mask left) {
    const Flight flight = walk_flight(walk);
    const real3 one = triple((real)(1.0f)), per_length = pick3(left, one, walk->sigma);
    real3 depth;
    depth.x = walk->sigma.x * distance;
    depth.y = walk->sigma.y * distance;
    depth.z = walk->sigma.z * distance;
    real3 density;
    density.x = flight_density(scene, flight, depth.x, left);
    density.y = flight_density(scene, flight, depth.y, left);
    density.z = flight_density(scene, flight, depth.z, left);
    real3 mixed = density;
    if (GUIDED) {
        mixed.x = guided_density(scene, guide, &guide->flight_x, flight, depth.x, density.x, left);
        mixed.y = guided_density(scene, guide, &guide->flight_y, flight, depth.y, density.y, left);
        mixed.z = guided_density(scene, guide, &guide->flight_z, flight, depth.z, density.z, left);
    }
    real3 scale = per_length;
    if (HAS(ANISOTROPY_RGB)) scale = product3(scale, walk->phase);
    walk_weigh(scene, walk, product3(density, scale), product3(mixed, scale), pick3(left, one, walk->albedo));
    walk->position.x = fma(walk->direction.x, distance, walk->position.x);
    walk->position.y = fma(walk->direction.y, distance, walk->position.y);
    walk->position.z = fma(walk->direction.z, distance, walk->position.z);
    walk->steps += pick(left, (natural)(0), (natural)(1));
}

// Russian roulette on the largest weight, never on the drawn channel's. Returns who survives: no NaN does, so that every
// walk ends. Those `exempt` do not play.
mask walk_roulette(const Scene *scene, Walk *walk, real xi, mask exempt) {
    const real sum = walk->weight.x + walk->weight.y + walk->weight.z;
    const real heaviest = pick(sum >= 0.0f, largest(walk->weight), (real)(-1.0f));
    const float threshold = WALK_ROULETTE;
    const mask survives = (xi * threshold < heaviest) | exempt;
    const real scale = pick((heaviest < threshold) & survives & (exempt == 0), threshold / heaviest, (real)(1.0f));
    walk->weight.x *= scale;
    walk->weight.y *= scale;
    walk->weight.z *= scale;
    return survives;
}

#endif
