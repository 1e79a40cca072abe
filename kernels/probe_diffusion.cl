// Entry points that let a test call diffusion/: profiles, lobes, and probe rays about a ball with a known answer.
#include "diffusion/medium.h"
#include "diffusion/probe.h"
#include "random/sampler.h"

// What a probe is asked; the host's copy is in tests/device/diffusion_probe.h.
typedef struct {
    float4 sigma, chance; // of the channels
    int model;
    float albedo, g, color; // of every channel
    float ball;             // radius
    uint direct, seed, count;
} DiffusionProbe;

Profile probed_profile(DiffusionProbe probe, float sigma) {
    return profile_of(probe.model, sigma, probe.albedo, probe.g, probe.color);
}

// Radii that are drawn, or with direct != 0 those that the host put into x. out: radius, pdf, eval.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void probe_profile(DiffusionProbe probe, global float4 *out) {
    const uint i = get_global_id(0);
    if (i >= probe.count) return;
    const Profile profile = probed_profile(probe, probe.sigma.x);
    const float xi = random_unit(random_hash((uint4)(probe.seed, i, 1u, 2u)).x);
    const float r = probe.direct != 0u ? out[i].x : profile_sample(&profile, xi);
    out[i] = (float4)(r, profile_pdf(&profile, r), profile_eval(&profile, r), 0.0f);
}

// Lobes of the colours (direct = 0) or albedos that the host put into x. out: albedo, single, multiple.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void probe_lobes(DiffusionProbe probe, global float4 *out) {
    const uint i = get_global_id(0);
    if (i >= probe.count) return;
    const Lobes lobes = lobes_of(probe.model, out[i].x, probe.direct != 0u, out[i].x, probe.g);
    out[i] = (float4)(lobes.albedo, lobes.single, lobes.multiple, 0.0f);
}

// Lines from the top of a ball, and where they cross it. out, two float4 each: weight of each channel, distance from the top
// (0: the line passes it).
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void probe_ball(DiffusionProbe probe, global float4 *out) {
    const uint i = get_global_id(0);
    if (i >= probe.count) return;
    ProbeProfiles profiles;
    profiles.channel[0] = probed_profile(probe, probe.sigma.x);
    profiles.channel[1] = probed_profile(probe, probe.sigma.y);
    profiles.channel[2] = probed_profile(probe, probe.sigma.z);
    profiles.chance[0] = probe.chance.x;
    profiles.chance[1] = probe.chance.y;
    profiles.chance[2] = probe.chance.z;
    const uint4 words = random_hash((uint4)(probe.seed, i, 3u, 4u));
    const float xi = random_unit(words.w);
    const uint c = xi < probe.chance.x ? 0u : xi < probe.chance.x + probe.chance.y ? 1u : 2u;
    const ProbeLine line =
        probe_line(profiles.channel + c, random_unit(words.x), random_unit(words.y), random_unit(words.z));
    const float3 centre = (float3)(0.0f, 0.0f, -probe.ball), from = line.across - centre;
    const float b = dot(from, line.along), d = b * b - dot(from, from) + probe.ball * probe.ball;
    out[2u * i] = out[2u * i + 1u] = (float4)(0.0f);
    if (!(d > 0.0f)) return;
    for (uint k = 0u; k < 2u; ++k) {
        const float3 offset = line.across + (-b + (k == 0u ? -sqrt(d) : sqrt(d))) * line.along;
        out[2u * i + k] = (float4)(probe_weight(&profiles, offset, (offset - centre) * (1.0f / probe.ball)), length3(offset));
    }
}
