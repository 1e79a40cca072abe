// Light from far away: constant, or a latitude-longitude image (row 0 at +y, u = 1/2 + atan2(z, x) / 2 pi).
#ifndef NACRE_LIGHT_ENVIRONMENT_H
#define NACRE_LIGHT_ENVIRONMENT_H

#include "lanes/math.h"
#include "lanes/scalar.h"
#include "random/hash.h"
#include "shared/view.h"

// Into the frame of the image: light->position holds cosine and sine of its rotation about +y.
float3 environment_turned(global const Light *light, float3 d, float sign) {
    const float c = light->position.x, s = sign * light->position.y;
    return (float3)(c * d.x - s * d.z, d.y, s * d.x + c * d.z);
}

// Texel coordinates of a direction, in texels.
float2 environment_coordinates(global const Light *light, float3 direction) {
    const float3 d = environment_turned(light, direction, 1.0f);
    const float u = 0.5f + atan2_scalar(d.z, d.x) * (0.5f * INV_PI);
    const float v = atan2_scalar(sqrt(d.x * d.x + d.z * d.z), d.y) * INV_PI;
    return (float2)(u * (float)light->width, v * (float)light->height);
}

// Bilinear, round the circle in u, held at the poles in v.
float3 environment_image(const Scene *scene, global const Light *light, float2 at) {
    const float x = at.x - 0.5f, y = clamp(at.y - 0.5f, 0.0f, (float)(light->height - 1u));
    const float fx = floor_scalar(x), fy = floor_scalar(y), s = x - fx, t = y - fy;
    const uint width = light->width, x0 = fx < 0.0f ? width - 1u : min((uint)fx, width - 1u);
    const uint x1 = x0 + 1u >= width ? 0u : x0 + 1u, y0 = (uint)fy, y1 = min(y0 + 1u, light->height - 1u);
    global const float4 *texels = scene->environment + light->first_texel;
    return mix(mix(texels[y0 * width + x0].xyz, texels[y0 * width + x1].xyz, s),
               mix(texels[y1 * width + x0].xyz, texels[y1 * width + x1].xyz, s), t) *
           light->radiance.xyz;
}

// Density per steradian of drawing a texel by its share of the light and a point in it evenly in u and v.
float environment_density(const Scene *scene, global const Light *light, float2 at) {
    const uint x = min((uint)at.x, light->width - 1u), y = min((uint)at.y, light->height - 1u);
    const float share = scene->environment[light->first_texel + y * light->width + x].w;
    float sine, cosine;
    sincos_scalar(0.5f * at.y / (float)light->height, &sine, &cosine);
    return share * (float)light->width * (float)light->height / max(1e-8f, 2.0f * PI * PI * sine);
}

// `texel` are two random words that draw a texel from the alias table, `inside` a point of it.
float3 environment_sample(const Scene *scene, global const Light *light, uint2 texel, float2 inside, float3 *radiance,
                          float *density) {
    const uint slot = mul_hi(texel.x, light->width * light->height);
    const AliasEntry entry = scene->environment_table[light->first_texel + slot];
    const uint chosen = random_unit(texel.y) < entry.threshold ? slot : entry.other;
    const float2 at = (float2)((float)(chosen % light->width) + inside.x, (float)(chosen / light->width) + inside.y);
    float s, c, sine, cosine;
    sincos_scalar(at.x / (float)light->width, &s, &c); // atan2 counts from -pi: both change sign
    sincos_scalar(0.5f * at.y / (float)light->height, &sine, &cosine);
    *radiance = environment_image(scene, light, at);
    *density = environment_density(scene, light, at);
    return environment_turned(light, (float3)(-sine * c, cosine, -sine * s), -1.0f);
}

#endif
