// Entry points that let a test call the rooms: samplers one by one, and whole walks in bodies with a known answer.
#include "bsdf/refraction.h"
#include "bsdf/specular.h"
#include "bsdf/lambert.h"
#include "flight/flight.h"
#include "guide/load.h"
#include "lanes/math.h"
#include "light/environment.h"
#include "phase/henyey_greenstein.h"
#include "random/sampler.h"
#include "sampling/hemisphere.h"
#include "shared/view.h"
#include "walk/medium.h"
#include "walk/walk.h"

// What a probe is asked; the host's copy is in tests/device/probe.h.
typedef struct {
    float4 sigma, albedo;
    float4 walk_anisotropy; // of walks, per channel
    float anisotropy, bleed, thickness; // thickness: slab; 0: half-space; < 0: sphere of radius -thickness
    float a, b, c;                      // free parameters of the other probes
    uint seed, first, reciprocal, entry, count, cap; // cap: scatters after which a walk ends, 0: never
} Probe;

// Free flights after `first` scatters. Depths are drawn, or with c > 0 spread evenly in their logarithm from exp(a) to exp(b).
// out: depth, transmittance, pdf, and the number that the depth was drawn with.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void probe_flight(
    global const Frame *frame, Probe probe, global float4 *out) {
    Scene view = {frame};
    const Scene *scene = &view;
    const uint i = get_global_id(0);
    if (i >= probe.count) return;
    const Flight flight =
        flight_of((real)(probe.bleed), (mask)(probe.reciprocal ? -1 : 0), (mask)(probe.first > 0u ? -1 : 0));
    const float xi = random_unit(random_hash((uint4)(probe.seed, i, 1u, 2u)).x);
    const real tau = probe.c > 0.0f ? (real)(exp(mix(probe.a, probe.b, (float)i / (float)probe.count)))
                                    : flight_sample(scene, flight, (real)(xi));
    out[i] = (float4)(tau, flight_transmittance(scene, flight, tau), flight_pdf(scene, flight, tau), xi);
}

// Directions scattered from the unit vector (a, b, c); out: direction, pdf.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void probe_phase(
    global const Frame *frame, Probe probe, global float4 *out) {
    Scene view = {frame};
    const Scene *scene = &view;
    const uint i = get_global_id(0);
    if (i >= probe.count) return;
    real3 from;
    from.x = probe.a;
    from.y = probe.b;
    from.z = probe.c;
    const uint4 words = random_hash((uint4)(probe.seed, i, 3u, 4u));
    const real3 d = phase_sample(scene, probe.anisotropy, random_unit(words.x), random_unit(words.y), from);
    out[i] = (float4)(d.x, d.y, d.z, phase_pdf(scene, probe.anisotropy, from, d));
}

// Angles of deflection from numbers of which a quarter are the lowest and a quarter the highest that there are.
// out: number, sine, cosine.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void probe_phase_angle(
    global const Frame *frame, Probe probe, global float4 *out) {
    const uint i = get_global_id(0);
    if (i >= probe.count) return;
    const uint end = (i >> 2) << 9;
    const uint word = (i & 1u) ? random_hash((uint4)(probe.seed, i, 3u, 5u)).x : (i & 2u) ? end : ~end;
    real sine, cosine;
    phase_angle(probe.anisotropy, random_unit(word), &sine, &cosine);
    out[i] = (float4)(random_unit(word), sine, cosine, 0.0f);
}

// Directions of the hemisphere samplers about +z: cosine (entry 0), uniform (entry 1); and of Lambert's lobe about the
// shading normal (a, b, c), folded at z = 0 (entry 2). out: direction, pdf.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void probe_hemisphere(
    global const Frame *frame, Probe probe, global float4 *out) {
    const uint i = get_global_id(0);
    if (i >= probe.count) return;
    const uint4 words = random_hash((uint4)(probe.seed, i, 5u, 6u));
    const float2 xi = (float2)(random_unit(words.x), random_unit(words.y));
    const float3 up = (float3)(0.0f, 0.0f, 1.0f), shading = (float3)(probe.a, probe.b, probe.c);
    if (probe.entry == 2u) {
        const float3 d = lambert_sample(xi, shading, up);
        out[i] = (float4)(d, lambert_pdf(d, shading, up));
    } else if (probe.entry == 1u) {
        out[i] = (float4)(uniform_hemisphere(xi), 0.5f * INV_PI);
    } else {
        const float3 d = cosine_hemisphere(xi);
        out[i] = (float4)(d, d.z * INV_PI);
    }
}

// The specular layer seen from (a, b, c), folded at z = 0: roughness^2 in sigma.x, index in sigma.y,
// shading normal in albedo.
Specular probe_layer(Probe probe) {
    Specular specular;
    specular.alpha = probe.sigma.x;
    specular.eta = probe.sigma.y;
    specular.metalness = 0.0f;
    specular.metal = (float3)(0.0f);
    specular.geometric = (float3)(0.0f, 0.0f, 1.0f);
    specular.normal = probe.albedo.xyz;
    const float3 view = (float3)(probe.a, probe.b, probe.c);
    float3 t, b;
    basis(specular.normal, &t, &b);
    specular.view = (float3)(dot(view, t), dot(view, b), dot(view, specular.normal));
    return specular;
}

// Directions into the medium below that layer. out: direction, and the share of its facet's light that is not reflected.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void probe_refracted(
    global const Frame *frame, Probe probe, global float4 *out) {
    const uint i = get_global_id(0);
    if (i >= probe.count) return;
    const uint4 words = random_hash((uint4)(probe.seed, i, 7u, 9u));
    const float2 xi = (float2)(random_unit(words.x), random_unit(words.y));
    const Specular specular = probe_layer(probe);
    float3 reflected;
    float base;
    specular_sample(&specular, xi, &reflected, &base);
    const float3 view = (float3)(probe.a, probe.b, probe.c);
    out[i] = (float4)(
        refracted_entry(view, specular.normal, specular.geometric, specular.alpha, specular.eta, xi), base);
}

// out: direction, and BSDF x cosine there; reflectance of the microfacet, what is left for the base.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void probe_specular(
    global const Frame *frame, Probe probe, global float4 *out) {
    const uint i = get_global_id(0);
    if (i >= probe.count) return;
    const uint4 words = random_hash((uint4)(probe.seed, i, 7u, 8u));
    const Specular specular = probe_layer(probe);
    float3 direction;
    float base;
    const float3 r = specular_sample(&specular, (float2)(random_unit(words.x), random_unit(words.y)), &direction, &base);
    out[2u * i] = (float4)(direction, specular_eval(&specular, direction).x);
    out[2u * i + 1u] = (float4)(r.x, base, 0.0f, 0.0f);
}

// Densities at directions that the host put into `out`: of the phase function from (a, b, c) (entry 0), of Lambert's lobe about
// (a, b, c) (entry 1), of the specular layer, which is its BSDF x cosine (entry 2). They go into w.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void probe_density(
    global const Frame *frame, Probe probe, global float4 *out) {
    Scene view = {frame};
    const Scene *scene = &view;
    const uint i = get_global_id(0);
    if (i >= probe.count) return;
    const float3 d = out[i].xyz, axis = (float3)(probe.a, probe.b, probe.c);
    if (probe.entry == 0u) {
        const real3 from = {axis.x, axis.y, axis.z}, to = {d.x, d.y, d.z};
        out[i].w = phase_pdf(scene, probe.anisotropy, from, to);
    } else if (probe.entry == 1u) {
        out[i].w = lambert_pdf(d, axis, (float3)(0.0f, 0.0f, 1.0f));
    } else {
        const Specular specular = probe_layer(probe);
        out[i].w = specular_eval(&specular, d).x;
    }
}

// Roulette of a walk with the weights `sigma`. out: its weights after that; the threshold if it survives, else 0.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void probe_roulette(
    global const Frame *frame, Probe probe, global float4 *out) {
    const uint i = get_global_id(0);
    if (i >= probe.count) return;
    Scene view = {frame};
    const Scene *scene = &view;
    Walk walk;
    walk.weight.x = probe.sigma.x;
    walk.weight.y = probe.sigma.y;
    walk.weight.z = probe.sigma.z;
    const float xi = random_unit(random_hash((uint4)(probe.seed, i, 9u, 10u)).x);
    const bool survives = bits(walk_roulette(scene, &walk, xi, 0)) != 0u;
    out[i] = (float4)(walk.weight.x, walk.weight.y, walk.weight.z, survives ? WALK_ROULETTE : 0.0f);
}

// Pairs of the Sobol sampler of dimension `entry`: sample i of key `seed`, or the first `first` samples of every key from
// there on. out: two numbers.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void probe_sobol(
    global const Frame *frame, Probe probe, global float2 *out) {
    const uint i = get_global_id(0);
    if (i >= probe.count) return;
    const uint each = probe.first > 0u ? probe.first : probe.count;
    const uint2 word = sobol_pair(probe.seed + i / each, probe.entry, i % each);
    out[i] = (float2)(random_unit(word.x), random_unit(word.y));
}

// Random numbers of the hash. out: four numbers.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void probe_hash(
    global const Frame *frame, Probe probe, global float4 *out) {
    const uint i = get_global_id(0);
    if (i >= probe.count) return;
    const uint4 w = random_hash((uint4)(probe.seed, i, probe.first, 9u));
    out[i] = (float4)(random_unit(w.x), random_unit(w.y), random_unit(w.z), random_unit(w.w));
}

// Functions that the kernels lean on: sin and cos of 2 pi a. out: sine, cosine.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void probe_sincos(
    global const Frame *frame, Probe probe, global float2 *out) {
    const uint i = get_global_id(0);
    if (i >= probe.count) return;
    float s, c;
    sincos_scalar((float)i / (float)(probe.count - 1u), &s, &c);
    out[i] = (float2)(s, c);
}

// Distance to the surface of the probe's body, and whether it is the side of the entry. A half-space and a slab lie at
// z >= 0, entered at z = 0; a sphere is entered at its lowest point, the origin.
float body_exit(float thickness, float3 p, float3 d, bool *back) {
    *back = false;
    if (thickness < 0.0f) {
        const float3 q = (float3)(p.x, p.y, p.z + thickness);
        const float b = dot(q, d), c = dot(q, q) - thickness * thickness;
        return -b + sqrt(fmax(0.0f, b * b - c));
    }
    if (d.z < 0.0f) return p.z / -d.z;
    *back = thickness > 0.0f && d.z > 0.0f;
    return *back ? (thickness - p.z) / d.z : INFINITY;
}

// One walk of `cap` scatters where there is no surface. out: where it ends.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void probe_infinite(
    global const Frame *frame, Probe probe, global float4 *out) {
    Scene view = {frame};
    const Scene *scene = &view;
    const uint i = get_global_id(0);
    if (i >= probe.count) return;
    Walk walk;
    walk.position = triple(0.0f);
    walk.direction = triple(0.57735027f);
    walk.sigma.x = probe.sigma.x;
    walk.sigma.y = probe.sigma.y;
    walk.sigma.z = probe.sigma.z;
    walk.albedo = triple(1.0f);
    walk.anisotropy = triple(probe.anisotropy);
    walk.bleed = probe.bleed;
    walk.reciprocal = (mask)probe.reciprocal;
    walk_begin(&walk, walk_start(scene, (float3)(1.0f), (float3)(1.0f), 0.5f));
    GuideLanes guide;
    const LaneSampler sampler = {probe.seed, i, 0u};
    while (walk.steps < probe.cap) {
        const uint4 words = random_hash((uint4)(probe.seed, i, walk.steps, 10u));
        const DirectionNumbers numbers = {random_unit(words.y), random_unit(words.z)};
        walk_direct(scene, &walk, &guide, 0.5f, 0.5f, numbers, sampler, 1u);
        walk_arrive(scene, &walk, &guide, walk_distance(scene, &walk, &guide, random_unit(words.x)), 0);
    }
    out[i] = (float4)(walk.position.x, walk.position.y, walk.position.z, 0.0f);
}

// The guide of a walk that enters at the origin along z. A sphere is a slab of its diameter.
void probe_guide(const Scene *scene, Probe probe, global const GuideMode *modes, GuideLanes *guide) {
    guide->outward.x = guide->outward.y = guide->offset = 0.0f;
    guide->outward.z = -1.0f;
    guide->thickness = probe.thickness > 0.0f ? probe.thickness : probe.thickness < 0.0f ? -2.0f * probe.thickness : GUIDE_THICK;
    guide->share = guide_share(GUIDE_SHARE, probe.bleed);
    guide->far_light = probe.a;
    guide->tries = 0u;
    mode_load(scene, &guide->x, 0u, modes, probe.walk_anisotropy.x);
    mode_load(scene, &guide->y, 0u, modes + 1, probe.walk_anisotropy.y);
    mode_load(scene, &guide->z, 0u, modes + 2, probe.walk_anisotropy.z);
}

// `count` walks per work-item. out, per work-item: [0] sum of what leaves on the entry's side (rgb; count of walks that left
// without a scatter), [1] squares, [2] sum of what leaves on the other side (w: largest weight), [3] squares (w: path
// length), [4..5] walks that left after 0..7 scatters.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void probe_walk(
    global const Frame *frame, Probe probe, global float4 *out, global const GuideMode *modes) {
    Scene view = {frame};
    const Scene *scene = &view;
    float4 near = (float4)(0.0f), near2 = (float4)(0.0f), far = (float4)(0.0f), far2 = (float4)(0.0f);
    float by_scatters[8] = {0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f};
    for (uint k = 0; k < probe.count; ++k) {
        const Sampler sampler = sampler_of(probe.seed, probe.first + get_global_id(0), k, 0u);
        const float2 entry = draw_pair(sampler, DRAW_ENTRY), first = draw_pair(sampler, DRAW_FIRST);
        const float3 inner = probe.entry == ENTRY_UNIFORM ? uniform_hemisphere(entry) : cosine_hemisphere(entry);
        Walk walk;
        walk.position.x = walk.position.y = walk.position.z = 0.0f;
        walk.direction.x = inner.x;
        walk.direction.y = inner.y;
        walk.direction.z = inner.z;
        walk.sigma.x = probe.sigma.x;
        walk.sigma.y = probe.sigma.y;
        walk.sigma.z = probe.sigma.z;
        walk.albedo.x = probe.albedo.x;
        walk.albedo.y = probe.albedo.y;
        walk.albedo.z = probe.albedo.z;
        walk.anisotropy.x = probe.walk_anisotropy.x;
        walk.anisotropy.y = probe.walk_anisotropy.y;
        walk.anisotropy.z = probe.walk_anisotropy.z;
        walk.bleed = probe.bleed;
        walk.reciprocal = (mask)probe.reciprocal;
        walk_begin(&walk, walk_start(scene, (float3)(1.0f), (float3)(1.0f), first.x));
        GuideLanes guide;
        if (GUIDED) probe_guide(scene, probe, modes, &guide);
        const LaneSampler lane = {sampler.key, sampler.sample, sampler.vertex};
        float length = 0.0f;
        for (;;) {
            const uint4 words = draw_bits(sampler, DRAW_WALK, walk.steps);
            const uint4 choice = draw_bits(sampler, DRAW_WALK_CHOICE, walk.steps);
            if (walk_chooses(scene)) walk_choose(scene, &walk, random_unit(choice.x));
            const DirectionNumbers numbers = {random_unit(words.y), random_unit(words.z)};
            if (walk_direct(scene, &walk, &guide, random_unit(choice.y), random_unit(choice.z), numbers, lane, 1u) != 0u) continue;
            const float distance = walk_distance(scene, &walk, &guide, walk.steps == 0u ? first.y : random_unit(words.x));
            bool back;
            const float exit = body_exit(probe.thickness, (float3)(walk.position.x, walk.position.y, walk.position.z),
                                         (float3)(walk.direction.x, walk.direction.y, walk.direction.z), &back);
            if (distance >= exit) {
                walk_arrive(scene, &walk, &guide, exit, 1);
                const float4 weight = (float4)(walk.weight.x, walk.weight.y, walk.weight.z, 0.0f);
                if (back) {
                    far += weight;
                    far2 += weight * weight;
                } else {
                    near += weight;
                    near2 += weight * weight;
                }
                far.w = fmax(far.w, fmax(weight.x, fmax(weight.y, weight.z)));
                far2.w += (length + exit) * weight.x;
                if (walk.steps == 0u) near.w += 1.0f;
                if (walk.steps < 8u) by_scatters[walk.steps] += 1.0f;
                break;
            }
            length += distance;
            walk_arrive(scene, &walk, &guide, distance, 0);
            if (!bits(walk_roulette(scene, &walk, random_unit(words.w), 0))) {
                if (!(walk.weight.x >= 0.0f)) near.x = NAN; // shows in the test
                break;
            }
            if (walk.steps == probe.cap) break;
        }
    }
    global float4 *sum = out + 6u * get_global_id(0);
    sum[0] = near;
    sum[1] = near2;
    sum[2] = far;
    sum[3] = far2;
    sum[4] = vload4(0, by_scatters);
    sum[5] = vload4(1, by_scatters);
}
