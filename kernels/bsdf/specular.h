// The reflecting layer: GGX over a dielectric or a metal. A microfacet is drawn first; it reflects r = F G2/G1 and lets 1 - r go on
// into the layer below, one of which the path draws, with a chance of its own, and is divided by that. E[r] is the layer's albedo
// E_spec(omega_o) exactly, so the base gets 1 - E_spec without a table and a furnace stays 1.
#ifndef NACRE_BSDF_SPECULAR_H
#define NACRE_BSDF_SPECULAR_H

#include "bsdf/fold.h"
#include "bsdf/fresnel.h"
#include "bsdf/microfacet.h"
#include "sampling/frame.h"

typedef struct {
    float alpha;
    float eta;       // dielectric, with specular_weight
    float metalness; // share of the surface that is metal
    float3 metal;    // its reflectance at normal incidence
    float3 normal, geometric;
    float3 view;     // towards the viewer, in the frame of `normal`
} Specular;

// The shading normal turned towards the viewer just so far that he sees it: at silhouettes of smooth meshes he may not.
float3 seen_normal(float3 shading, float3 view) {
    const float least = 1e-3f, seen = dot(shading, view);
    return seen >= least ? shading : unit3(shading + (least - seen) * view);
}

float3 specular_reflectance(const Specular *specular, float dielectric, float cosine) {
    const float3 r = (float3)(dielectric);
    if (specular->metalness <= 0.0f) return r;
    return mix(r, fresnel_schlick(cosine, specular->metal), specular->metalness);
}

// Draws a direction. Returns the reflectance of its microfacet per channel, F G2/G1 (0 where it points into the surface);
// *base is what the layer below gets: nothing under metal, 1 - r under the dielectric.
float3 specular_sample(const Specular *specular, float2 xi, float3 *direction, float *base) {
    const float3 h = microfacet_sample(specular->view, specular->alpha, xi);
    const float cosine = min(1.0f, dot(specular->view, h));
    const float3 light = 2.0f * cosine * h - specular->view;
    *base = 1.0f - specular->metalness;
    *direction = specular->geometric;
    if (light.z <= 0.0f) return (float3)(0.0f);
    *direction = fold(to_world(light, specular->normal), specular->geometric);
    const float both = microfacet_seen_by_both(specular->view, light, specular->alpha);
    const float dielectric = fresnel_dielectric(cosine, specular->eta);
    *base *= 1.0f - dielectric * both;
    return specular_reflectance(specular, dielectric, cosine) * both;
}

float3 specular_unfolded(const Specular *specular, float3 world) {
    float3 t, b;
    basis(specular->normal, &t, &b);
    const float3 light = (float3)(dot(world, t), dot(world, b), dot(world, specular->normal));
    if (light.z <= 0.0f) return (float3)(0.0f);
    const float3 h = unit3(light + specular->view);
    const float cosine = min(1.0f, dot(specular->view, h));
    return specular_reflectance(specular, fresnel_dielectric(cosine, specular->eta), cosine) *
           (microfacet_seen_by_both(specular->view, light, specular->alpha) *
            microfacet_reflection_pdf(specular->view, h, specular->alpha));
}

// BSDF x cosine, per channel.
float3 specular_eval(const Specular *specular, float3 world) {
    if (dot(world, specular->geometric) <= 0.0f) return (float3)(0.0f);
    return specular_unfolded(specular, world) + specular_unfolded(specular, unfold(world, specular->geometric));
}

// About how dense reflected directions are where the BSDF x cosine is r, for the balance with draws of lights: the largest channel.
float specular_density(float3 r) { return max(r.x, max(r.y, r.z)); }

#endif
