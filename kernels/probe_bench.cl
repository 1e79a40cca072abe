// Entry points that benchmarks time: one function each, REPEATS calls over LANES a work-item, so that a launch's own cost does
// not show. Arguments change from call to call and results are summed, so that no call can be left out; calls do not wait for
// one another.
#include "flight/flight.h"
#include "lanes/math.h"
#include "phase/henyey_greenstein.h"
#include "random/hash.h"
#include "shared/view.h"
#include "walk/clearance.h"

#ifndef REPEATS
#define REPEATS 256
#endif

real3 triplet(real x, real y, real z) {
    const real3 v = {x, y, z};
    return v;
}
real sum_of(real3 v) { return v.x + v.y + v.z; }

real sine_and_cosine(real x) {
    real s, c;
    sincos_turns(x, &s, &c);
    return s + c;
}

real hash_and_unit(natural x) {
    const Natural4 v = lane_hash(x, x ^ 1u, x ^ 2u, x ^ 3u);
    return lane_unit(v.x ^ v.y ^ v.z ^ v.w);
}

// A kernel bench_NAME that evaluates `value` with x in (0, 1), another one for every lane and turn. in: numbers in (0, 1/2);
// out: sums; g and bleed are for the rooms that take them. The scene is empty: its features are known to the compiler.
#define BENCH(name, value)                                                                                             \
    kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void bench_##name(                                  \
        global const real *in, global real *out, float anisotropy, float bleed) {                                      \
        Scene view = {0};                                                                                              \
        const Scene *scene = &view;                                                                                    \
        const size_t i = get_global_id(0);                                                                             \
        const real first = in[i], g = (real)(anisotropy);                                                              \
        const real3 from = triplet((real)(0.6f), (real)(0.0f), (real)(-0.8f));                                         \
        const Flight flight = flight_of((real)(bleed), first < 0.25f, first < 0.125f);                                 \
        real sum = (real)(0.0f);                                                                                       \
        for (uint k = 0; k < REPEATS; ++k) {                                                                           \
            const real x = first + (float)k * (0.5f / REPEATS);                                                        \
            sum += value;                                                                                              \
        }                                                                                                              \
        out[i] = sum;                                                                                                  \
    }

BENCH(nothing, x)
BENCH(log, lane_log(x))
BENCH(exp, lane_exp(x))
BENCH(log1p, lane_log1p(x))
BENCH(expm1, lane_expm1(x))
BENCH(sincos, sine_and_cosine(x))
BENCH(hash, hash_and_unit(as_natural(x)))
BENCH(phase_sample, sum_of(phase_sample(scene, g, x, 1.0f - x, from)))
BENCH(phase_pdf, phase_pdf(scene, g, triplet(x, 1.0f - x, x), from))
BENCH(flight_sample, flight_sample(scene, flight, x))
BENCH(flight_density, flight_density(scene, flight, x, x < 0.5f))

// Look-ups all over the box of a clearance field, `extent` wide from its corner.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void bench_clearance(
    global const real *in, global real *out, global const Clearance *field, global const uint *bricks, float4 extent) {
    const size_t i = get_global_id(0);
    ClearanceLanes lanes;
    for (uint l = 0; l < LANES; ++l) clearance_set(&lanes, l, field);
    const real first = in[i];
    real sum = (real)(0.0f);
    for (uint k = 0; k < REPEATS; ++k) {
        const real x = first + (float)k * (0.5f / REPEATS), y = 7.0f * x - floor(7.0f * x), z = 53.0f * x - floor(53.0f * x);
        sum += clearance_at(bricks, &lanes, fma(x, (real)(extent.x), lanes.corner_x),
                            fma(y, (real)(extent.y), lanes.corner_y), fma(z, (real)(extent.z), lanes.corner_z));
    }
    out[i] = sum;
}
