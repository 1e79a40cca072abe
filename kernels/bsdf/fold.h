// Directions of a lobe about the shading normal that point into the surface are mirrored at the geometric plane. So no
// energy is lost and none passes through: a white surface stays white under smooth normals, without black edges or leaks.
#ifndef NACRE_BSDF_FOLD_H
#define NACRE_BSDF_FOLD_H

float3 fold(float3 direction, float3 geometric) {
    const float below = dot(direction, geometric);
    return below < 0.0f ? direction - 2.0f * below * geometric : direction;
}

float3 unfold(float3 direction, float3 geometric) { return direction - 2.0f * dot(direction, geometric) * geometric; }

#endif
