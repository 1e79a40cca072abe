// Lambert's cosine lobe about the shading normal, folded. value = BSDF x cosine / albedo = pdf: its weight is 1.
#ifndef NACRE_BSDF_LAMBERT_H
#define NACRE_BSDF_LAMBERT_H

#include "bsdf/fold.h"
#include "sampling/hemisphere.h"
#include "shared/view.h"

float3 lambert_sample(float2 xi, float3 shading, float3 geometric) {
    return fold(to_world(cosine_hemisphere(xi), shading), geometric);
}

// Per steradian. `direction` on the geometric normal's side, else 0.
float lambert_pdf(float3 direction, float3 shading, float3 geometric) {
    if (dot(direction, geometric) <= 0.0f) return 0.0f;
    return INV_PI * (max(0.0f, dot(direction, shading)) + max(0.0f, dot(unfold(direction, geometric), shading)));
}

#endif
