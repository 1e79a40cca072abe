// Bilinear look-ups in the texel buffer, repeated outside [0, 1].
#ifndef NACRE_TEXTURE_TEXTURE_H
#define NACRE_TEXTURE_TEXTURE_H

#include "lanes/scalar.h"
#include "shared/view.h"

float4 texture_texel(const Scene *scene, global const Texture *texture, uint x, uint y) {
    const uint at = texture->first + (y * texture->width + x) * texture->channels;
    const float4 texel = vload_half4(0, scene->texels + at); // one alone PoCL would convert in twenty instructions
    return texture->channels == 1u ? texel.xxxx : texel;
}

// uv: (0, 0) is the lower left corner of the picture, row 0 of the texels its top.
float4 texture_sample(const Scene *scene, uint index, float2 uv) {
    global const Texture *texture = scene->textures + index;
    const float width = (float)texture->width, height = (float)texture->height;
    float u = fma(uv.x, texture->scale_u, texture->offset_u), v = 1.0f - fma(uv.y, texture->scale_v, texture->offset_v);
    u = (u - floor_scalar(u)) * width - 0.5f;
    v = (v - floor_scalar(v)) * height - 0.5f;
    const float fx = floor_scalar(u), fy = floor_scalar(v), s = u - fx, t = v - fy;
    const uint x0 = fx < 0.0f ? texture->width - 1u : (uint)fx, x1 = x0 + 1u >= texture->width ? 0u : x0 + 1u;
    const uint y0 = fy < 0.0f ? texture->height - 1u : (uint)fy, y1 = y0 + 1u >= texture->height ? 0u : y0 + 1u;
    const float4 top = mix(texture_texel(scene, texture, x0, y0), texture_texel(scene, texture, x1, y0), s);
    const float4 bottom = mix(texture_texel(scene, texture, x0, y1), texture_texel(scene, texture, x1, y1), s);
    const float4 texel = mix(top, bottom, t);
    switch (texture->channel) {
    case 0: return (float4)(texel.x);
    case 1: return (float4)(texel.y);
    case 2: return (float4)(texel.z);
    case 3: return (float4)(texel.w);
    default: return texel;
    }
}

#endif
