// A material's parameters at a point.
#ifndef NACRE_BSDF_MATERIAL_H
#define NACRE_BSDF_MATERIAL_H

#include "texture/texture.h"

float3 material_color(const Scene *scene, global const Material *material, int parameter, float2 uv) {
    if (HAS(TEXTURES) && material->texture[parameter] >= 0)
        return texture_sample(scene, (uint)material->texture[parameter], uv).xyz;
    return material->value[parameter].xyz;
}

float material_number(const Scene *scene, global const Material *material, int parameter, float2 uv) {
    return material_color(scene, material, parameter, uv).x;
}

#endif
