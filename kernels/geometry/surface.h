// What a ray hit: position with its rounding error, normals, texture coordinates.
#ifndef NACRE_GEOMETRY_SURFACE_H
#define NACRE_GEOMETRY_SURFACE_H

#include "geometry/object.h"
#include "geometry/ray.h"
#include "geometry/traverse.h"
#include "shared/view.h"
#include "texture/texture.h"

typedef struct {
    float3 position, error; // error: bound per component on the rounding of position
    float3 geometric;       // unit normal of the triangle, on its counter-clockwise side
    float3 shading;         // interpolated or mapped normal, on the same side as `geometric`
    float2 uv;
    uint object, primitive;
} Surface;

// The counter-clockwise normal of a hit triangle, not normalised.
float3 hit_normal(const Scene *scene, Hit hit) {
    const float3 v0 = triangle_vertex(scene->blocks, hit.block, hit.slot, 0);
    return triangle_normal(triangle_vertex(scene->blocks, hit.block, hit.slot, 1) - v0,
                           triangle_vertex(scene->blocks, hit.block, hit.slot, 2) - v0);
}

// Tangent-space normal map (OpenGL convention: +y up the picture). Tangents follow the texture coordinates.
float3 mapped_normal(const Scene *scene, global const Material *material, const Surface *surface, float3 n,
                     const float3 *v, const float2 *uv) {
    const float3 e1 = v[1] - v[0], e2 = v[2] - v[0];
    global const Texture *texture = scene->textures + material->texture[PARAMETER_geometry_normal];
    const float2 scale = (float2)(texture->scale_u, texture->scale_v);
    const float2 d1 = (uv[1] - uv[0]) * scale, d2 = (uv[2] - uv[0]) * scale;
    const float area = d1.x * d2.y - d1.y * d2.x;
    if (area == 0.0f) return n; // no tangent where the picture is collapsed
    const float3 along = (e1 * d2.y - e2 * d1.y) / area;
    const float3 t0 = along - n * dot(n, along);
    const float length2 = dot(t0, t0);
    if (!(length2 > 0.0f)) return n;
    const float3 t = t0 * (1.0f / sqrt(length2)), b = cross(n, t) * (area < 0.0f ? -1.0f : 1.0f);
    const float3 m =
        texture_sample(scene, (uint)material->texture[PARAMETER_geometry_normal], surface->uv).xyz * 2.0f - 1.0f;
    const float3 bent = t * m.x + b * m.y + n * m.z;
    const float bent2 = dot(bent, bent);
    return bent2 > 0.0f ? bent * (1.0f / sqrt(bent2)) : n;
}

Surface surface_at(const Scene *scene, Ray ray, Hit hit) {
    Surface surface;
    const float3 v[3] = {triangle_vertex(scene->blocks, hit.block, hit.slot, 0),
                         triangle_vertex(scene->blocks, hit.block, hit.slot, 1),
                         triangle_vertex(scene->blocks, hit.block, hit.slot, 2)};
    const float3 w = hit_barycentrics(ray, scene->blocks, hit);
    surface.position = hit_point(scene->blocks, hit, w, &surface.error);
    surface.primitive = hit.primitive;
    surface.object = object_of(scene, hit.primitive);
    surface.geometric = unit3(triangle_normal(v[1] - v[0], v[2] - v[0]));
    surface.shading = surface.geometric;
    surface.uv = (float2)(0.0f);
    uint3 corner;
    if (HAS(SMOOTH) || HAS(TEXTURES)) corner = vload3(hit.primitive, scene->triangles);
    if (HAS(SMOOTH)) {
        const float3 n = w.x * vload3(corner.x, scene->normals) + w.y * vload3(corner.y, scene->normals) +
                         w.z * vload3(corner.z, scene->normals);
        const float length2 = dot(n, n); // 0 on objects without vertex normals
        if (length2 > 0.0f) surface.shading = n * (1.0f / sqrt(length2));
    }
    if (HAS(TEXTURES)) {
        const float2 uv[3] = {vload2(corner.x, scene->uvs), vload2(corner.y, scene->uvs), vload2(corner.z, scene->uvs)};
        surface.uv = w.x * uv[0] + w.y * uv[1] + w.z * uv[2];
        if (HAS(NORMAL_MAP)) {
            global const Material *material = scene->materials + scene->objects[surface.object].material;
            if (material->texture[PARAMETER_geometry_normal] >= 0)
                surface.shading = mapped_normal(scene, material, &surface, surface.shading, v, uv);
        }
    }
    if (dot(surface.shading, surface.geometric) <= 0.0f) surface.shading = surface.geometric;
    return surface;
}

#endif
