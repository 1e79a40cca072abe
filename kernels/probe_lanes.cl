// Entry points that run the rooms written over lanes, LANES inputs per work-item, so that a test can compare one number of
// lanes with another. Arrays are by input, whatever LANES is: their lengths are multiples of it.
#include "lanes/math.h"
#include "lanes/scalar.h"
#include "random/hash.h"
#include "shared/view.h"
#include "walk/walk.h"

// What the kernels use where paths are alone, lane by lane.
#define EACH_LANE(y, x, f)                                                                                             \
    for (uint l = 0u; l < LANES; ++l) {                                                                                \
        const float v = LANE_FLOAT(x, l);                                                                              \
        LANE_FLOAT(y, l) = f;                                                                                          \
    }

// function: 0 log, 1 exp, 2 log1p, 3 expm1, 4 sine and 5 cosine of turns, 6 random_unit of bits; built-ins: 7 square root,
// 8 reciprocal, 9 x x - 1 rounded once (fma); of lanes/scalar.h: 10 floor, 11 atan2(x, 1), 12 atan2(1, x), 13 length of
// (x, x, x), 14 the x of (x, x, x) normalised.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void probe_function(
    global const real *in, global real *out, uint function) {
    const size_t i = get_global_id(0);
    const real x = in[i];
    real s, c, y = x;
    switch (function) {
    case 0: out[i] = lane_log(x); break;
    case 1: out[i] = lane_exp(x); break;
    case 2: out[i] = lane_log1p(x); break;
    case 3: out[i] = lane_expm1(x); break;
    case 4: sincos_turns(x, &s, &c); out[i] = s; break;
    case 5: sincos_turns(x, &s, &c); out[i] = c; break;
    case 6: out[i] = lane_unit(as_natural(x)); break;
    case 7: out[i] = sqrt(x); break;
    case 8: out[i] = 1.0f / x; break;
    case 9: out[i] = fma(x, x, (real)(-1.0f)); break;
    case 10: EACH_LANE(y, x, floor_scalar(v)) out[i] = y; break;
    case 11: EACH_LANE(y, x, atan2_scalar(v, 1.0f)) out[i] = y; break;
    case 12: EACH_LANE(y, x, atan2_scalar(1.0f, v)) out[i] = y; break;
    case 13: EACH_LANE(y, x, length3((float3)(v))) out[i] = y; break;
    default: EACH_LANE(y, x, unit3((float3)(v)).x) out[i] = y;
    }
}

// out: the four words of the hash of (x, 1, 2, x), word by word: [4][inputs]; then those of random_hash, which is scalar.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void probe_lane_hash(
    global const natural *in, global natural *out) {
    const size_t i = get_global_id(0), n = get_global_size(0);
    const Natural4 v = lane_hash(in[i], (natural)(1u), (natural)(2u), in[i]);
    out[i] = v.x;
    out[n + i] = v.y;
    out[2u * n + i] = v.z;
    out[3u * n + i] = v.w;
    for (size_t k = i * LANES; k < (i + 1u) * LANES; ++k) {
        const uint x = ((global const uint *)in)[k];
        const uint4 w = random_hash((uint4)(x, 1u, 2u, x));
        global uint *words = (global uint *)(out + 4u * n);
        words[k] = w.x;
        words[n * LANES + k] = w.y;
        words[2u * n * LANES + k] = w.z;
        words[3u * n * LANES + k] = w.w;
    }
}

// Eight flights of walk number x in an unbounded medium, then one to the surface; lanes differ in bleed, anisotropy and flight
// law. out: [12][inputs] weight, position, direction, who survived, and of the last flight (as one that scattered):
// flight_density to the surface less the transmittance, to a scatter less the pdf.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void probe_lane_walk(
    global const natural *in, global real *out, global const Frame *frame) {
    Scene view = {frame};
    const Scene *scene = &view;
    const size_t i = get_global_id(0), n = get_global_size(0);
    const natural x = in[i], zero = (natural)(0u);
    const real one = (real)(1.0f), none = (real)(0.0f);
    Walk walk;
    walk.position = triple(none);
    walk.direction = triple((real)(0.57735027f));
    walk.sigma = triple(one);
    walk.sigma.y = (real)(2.0f);
    walk.sigma.z = (real)(30.0f); // whose light the others' walks soon have lost
    walk.albedo = triple((real)(0.7f));
    walk.albedo.z = (real)(0.2f);
    walk.anisotropy.x = pick((x & 1u) != 0u, (real)(0.8f), none);
    walk.bleed = pick((x & 2u) != 0u, (real)(0.5f), none);
    walk.reciprocal = (x & 4u) != 0u;
    const real xi = lane_unit(lane_hash(x, zero, zero, zero).x);
    walk.steps = zero;
    for (uint l = 0u; l < LANES; ++l) { // as lane_load does it: each lane has its own start
        const WalkStart start = walk_start(scene, (float3)(1.0f), (float3)(1.0f), LANE_FLOAT(xi, l));
        LANE_FLOAT(walk.weight.x, l) = start.weight.x;
        LANE_FLOAT(walk.weight.y, l) = start.weight.y;
        LANE_FLOAT(walk.weight.z, l) = start.weight.z;
        LANE_FLOAT(walk.share.x, l) = start.share.x;
        LANE_FLOAT(walk.share.y, l) = start.share.y;
        LANE_FLOAT(walk.share.z, l) = start.share.z;
        LANE_INT(walk.channel, l) = (int)start.channel;
    }
    const mask yes = zero == 0u, no = zero == 1u;
    mask alive = yes;
    GuideLanes guide; // these walks have none
    LaneSampler sampler;
    sampler.key = sampler.sample = sampler.vertex = x;
    real distance = none;
    for (uint step = 0u; step < 8u; ++step) {
        const Natural4 w = lane_hash(x, zero + step, zero + 1u, zero);
        if (walk_chooses(scene)) walk_choose(scene, &walk, lane_unit(lane_hash(x, zero + step, zero + 2u, zero).x));
        DirectionNumbers numbers;
        numbers.cosine = lane_unit(w.y);
        numbers.azimuth = lane_unit(w.z);
        walk_direct(scene, &walk, &guide, numbers.cosine, numbers.cosine, numbers, sampler, LANES_ALL);
        distance = walk_distance(scene, &walk, &guide, lane_unit(w.x));
        walk_arrive(scene, &walk, &guide, distance, no);
        alive &= walk_roulette(scene, &walk, lane_unit(w.w), no);
    }
    const Flight flight = walk_flight(&walk);
    walk_arrive(scene, &walk, &guide, distance, yes);
    out[i] = walk.weight.x;
    out[n + i] = walk.weight.y;
    out[2u * n + i] = walk.weight.z;
    out[3u * n + i] = walk.position.x;
    out[4u * n + i] = walk.position.y;
    out[5u * n + i] = walk.position.z;
    out[6u * n + i] = walk.direction.x;
    out[7u * n + i] = walk.direction.y;
    out[8u * n + i] = walk.direction.z;
    out[9u * n + i] = pick(alive, one, none);
    out[10u * n + i] = flight_density(scene, flight, distance, yes) - flight_transmittance(scene, flight, distance);
    out[11u * n + i] = flight_density(scene, flight, distance, no) - flight_pdf(scene, flight, distance);
}
