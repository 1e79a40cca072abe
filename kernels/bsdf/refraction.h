// What passes a dielectric interface. `eta` >= 1: index of the inside over that of the outside.
#ifndef NACRE_BSDF_REFRACTION_H
#define NACRE_BSDF_REFRACTION_H

#include "bsdf/fold.h"
#include "bsdf/fresnel.h"
#include "bsdf/microfacet.h"
#include "sampling/frame.h"

// The way into the medium from `view`, a unit vector outside, through a facet with the normal h, dot(view, h) >= 0. Snell's law
// as in Walter et al. 2007, eq 40, times eta. The facet's side and the viewer's both point out, so it points into the surface
// whatever h is: no facet's light is lost.
float3 refract_inwards(float3 view, float3 h, float eta) {
    const float cosine = clamp(dot(view, h), 0.0f, 1.0f);
    const float inner = sqrt(fma(cosine, cosine, (eta - 1.0f) * (eta + 1.0f))); // eta times the cosine inside
    return -unit3(view + (inner - cosine) * h);
}

// Direction into a medium below a surface of GGX microfacets about `normal`, which `view` sees (see seen_normal); xi draws the
// facet as specular_sample does. A direction that is outside by the geometric normal is mirrored in.
float3 refracted_entry(float3 view, float3 normal, float3 geometric, float alpha, float eta, float2 xi) {
    float3 t, b;
    basis(normal, &t, &b);
    const float3 seen = (float3)(dot(view, t), dot(view, b), dot(view, normal));
    return fold(to_world(refract_inwards(seen, microfacet_sample(seen, alpha, xi), eta), normal), -geometric);
}

// Reflectance from inside; `cosine` in [0, 1] is inside. `eta` bends the light, `reflecting` is the index that reflects it,
// weighted_ior(eta, specular_weight): as on the way in, OpenPBR's weight changes how much is reflected, not where light goes.
float fresnel_inside(float cosine, float eta, float reflecting) {
    const float sine2 = eta * eta * (1.0f - cosine) * (1.0f + cosine); // outside
    return sine2 < 1.0f ? fresnel_dielectric(sqrt(1.0f - sine2), reflecting) : 1.0f;
}

#endif
