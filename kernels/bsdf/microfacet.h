// GGX microfacets (Walter et al. 2007) with visible normals (Heitz 2018, "Sampling the GGX Distribution of Visible Normals").
// Directions are in the frame of the shading normal, z up; `alpha` = roughness^2.
#ifndef NACRE_BSDF_MICROFACET_H
#define NACRE_BSDF_MICROFACET_H

#include "lanes/math.h"
#include "lanes/scalar.h"
#include "shared/view.h"

// Below this the lobe is narrower than float can tell; it then looks like a mirror all the same.
#define MICROFACET_MIN_ALPHA 1e-3f

float microfacet_alpha(float roughness) { return max(MICROFACET_MIN_ALPHA, roughness * roughness); }

// Normal distribution; tan^2 from the components of h keeps its digits for tiny alpha.
float microfacet_distribution(float3 h, float alpha) {
    const float x = h.x / alpha, y = h.y / alpha, d = x * x + y * y + h.z * h.z;
    return INV_PI / (alpha * alpha * d * d);
}

float microfacet_lambda(float3 v, float alpha) {
    return 0.5f * (sqrt(1.0f + alpha * alpha * (v.x * v.x + v.y * v.y) / (v.z * v.z)) - 1.0f);
}

// Share of microfacets that v sees (Smith); v.z > 0.
float microfacet_visible(float3 v, float alpha) { return 1.0f / (1.0f + microfacet_lambda(v, alpha)); }

// Share that both see, given that `view` does: the height-correlated G2 / G1.
float microfacet_seen_by_both(float3 view, float3 light, float alpha) {
    const float a = microfacet_lambda(view, alpha);
    return (1.0f + a) / (1.0f + a + microfacet_lambda(light, alpha));
}

// A microfacet normal, seen from `view` (view.z > 0), in proportion to its projected area.
float3 microfacet_sample(float3 view, float alpha, float2 xi) {
    const float3 v = unit3((float3)(alpha * view.x, alpha * view.y, view.z));
    const float length2 = v.x * v.x + v.y * v.y;
    const float3 t1 = length2 > 0.0f ? (float3)(-v.y, v.x, 0.0f) * (1.0f / sqrt(length2)) : (float3)(1.0f, 0.0f, 0.0f);
    const float3 t2 = cross(v, t1);
    float s, c;
    sincos_scalar(xi.y, &s, &c);
    const float r = sqrt(xi.x), p1 = r * c, side = 0.5f * (1.0f + v.z);
    const float p2 = (1.0f - side) * sqrt(max(0.0f, 1.0f - p1 * p1)) + side * r * s;
    const float3 n = p1 * t1 + p2 * t2 + sqrt(max(0.0f, 1.0f - p1 * p1 - p2 * p2)) * v;
    return unit3((float3)(alpha * n.x, alpha * n.y, max(1e-6f, n.z)));
}

// Density of the direction that `h` reflects `view` to, per steradian.
float microfacet_reflection_pdf(float3 view, float3 h, float alpha) {
    return microfacet_visible(view, alpha) * microfacet_distribution(h, alpha) / (4.0f * view.z);
}

#endif
