// Probe rays: where a surface is crossed by a line that stands on a disk about the entry. King, Kulla, Conty, Fajardo 2013,
// "BSSRDF Importance Sampling": the disk's axis is the normal (1/2), tangent or bitangent (1/4 each), a channel's profile
// gives the radius, and the balance heuristic is over axes and channels. Nothing is cut off: the line has no ends, profiles
// no largest radius.
#ifndef NACRE_DIFFUSION_PROBE_H
#define NACRE_DIFFUSION_PROBE_H

#include "diffusion/profile.h"
#include "sampling/frame.h"

typedef struct {
    float3 tangent, bitangent, normal;
} ProbeFrame;

ProbeFrame probe_frame(float3 normal) {
    ProbeFrame frame;
    frame.normal = normal;
    basis(normal, &frame.tangent, &frame.bitangent);
    return frame;
}

// Profiles of the channels, and with which chance each draws the radius.
typedef struct {
    Profile channel[3];
    float chance[3];
} ProbeProfiles;

// A line: `along` is its direction, `across` where it passes the entry, both unit or in lengths in the frame (t, b, n).
typedef struct {
    float3 along, across;
} ProbeLine;

// xi_axis, xi_radius, xi_angle in (0, 1).
ProbeLine probe_line(const Profile *profile, float xi_axis, float xi_radius, float xi_angle) {
    float s, c;
    sincos_scalar(xi_angle, &s, &c);
    const float r = profile_sample(profile, xi_radius);
    s *= r;
    c *= r;
    ProbeLine line;
    if (xi_axis < 0.5f) {
        line.along = (float3)(0.0f, 0.0f, 1.0f);
        line.across = (float3)(c, s, 0.0f);
    } else if (xi_axis < 0.75f) {
        line.along = (float3)(1.0f, 0.0f, 0.0f);
        line.across = (float3)(0.0f, c, s);
    } else {
        line.along = (float3)(0.0f, 1.0f, 0.0f);
        line.across = (float3)(s, 0.0f, c);
    }
    return line;
}

float3 probe_world(const ProbeFrame *frame, float3 v) {
    return v.x * frame->tangent + v.y * frame->bitangent + v.z * frame->normal;
}

// Density per area of surface with which lines cross it at `offset` from the entry, where its unit normal is `normal`; both in
// the frame.
float probe_pdf(const ProbeProfiles *profiles, float3 offset, float3 normal) {
    const float3 square = offset * offset, cosine = fabs(normal);
    float sum = 0.0f;
    for (int c = 0; c < 3; ++c) {
        if (!(profiles->chance[c] > 0.0f)) continue;
        const Profile *profile = profiles->channel + c;
        sum += profiles->chance[c] * (0.5f * cosine.z * profile_pdf(profile, sqrt(square.x + square.y)) +
                                      0.25f * cosine.x * profile_pdf(profile, sqrt(square.y + square.z)) +
                                      0.25f * cosine.y * profile_pdf(profile, sqrt(square.x + square.z)));
    }
    return sum;
}

// What each channel's light that left at `offset` is worth, of 1 in all. 0 where float holds neither density.
float3 probe_weight(const ProbeProfiles *profiles, float3 offset, float3 normal) {
    const float pdf = probe_pdf(profiles, offset, normal), r = length3(offset);
    if (pdf == 0.0f) return (float3)(0.0f);
    return (float3)(profile_eval(profiles->channel, r), profile_eval(profiles->channel + 1, r),
                    profile_eval(profiles->channel + 2, r)) * (1.0f / pdf);
}

#endif
