// Directions of the hemisphere about +z.
#ifndef NACRE_SAMPLING_HEMISPHERE_H
#define NACRE_SAMPLING_HEMISPHERE_H

#include "lanes/math.h"
#include "sampling/frame.h"

// Density cos(theta) / pi. The cosine is sqrt(xi), never 0; the sine from 1 - xi has no cancellation.
float3 cosine_hemisphere(float2 xi) {
    float s, c;
    const float sine = sqrt(1.0f - xi.x);
    sincos_scalar(xi.y, &s, &c);
    return (float3)(sine * c, sine * s, sqrt(xi.x));
}

// Density 1 / (2 pi).
float3 uniform_hemisphere(float2 xi) {
    float s, c;
    const float sine = sqrt((1.0f - xi.x) * (1.0f + xi.x));
    sincos_scalar(xi.y, &s, &c);
    return (float3)(sine * c, sine * s, xi.x);
}

#endif
