// Lights as a whole: draw one (light/choice.h) and a point on it; how dense that draw is for a direction that the
// BSDF found; what a ray meets. An environment of constant radiance is never drawn: the BSDF's own directions serve it best.
#ifndef NACRE_LIGHT_LIGHT_H
#define NACRE_LIGHT_LIGHT_H

#include "bsdf/material.h"
#include "geometry/object.h"
#include "light/choice.h"
#include "light/environment.h"

typedef struct {
    float3 direction; // unit, from the point that is lit
    float distance;   // MAXFLOAT: far away
    float3 target;    // where a shadow ray has to arrive, unless far away: just before the light's own surface
    float3 radiance;  // divided by the density of the draw; point and directional: their irradiance facing the light
    float density;    // per steradian, 0: a single direction (no other way to find it)
} LightSample;

// Balance heuristic of two ways to find a direction.
float light_weight(float mine, float other) { return mine / (mine + other); }

// Density per steradian of drawing the point at `distance` on a flat light that is drawn with `chance`.
float light_area_density(global const Light *light, float chance, float distance, float cosine) {
    return chance * distance * distance / (light->normal.w * cosine);
}

float3 light_emission(const Scene *scene, uint object, float2 uv) {
    global const Material *material = scene->materials + scene->objects[object].material;
    return material_color(scene, material, PARAMETER_emission_color, uv) *
           (material_number(scene, material, PARAMETER_emission_luminance, uv) * scene->frame->emission_scale);
}

bool light_sample_flat(const Scene *scene, global const Light *light, float chance, float2 xi, float3 position,
                       LightSample *sample) {
    float a = xi.x, b = xi.y;
    const bool triangle = light->kind == LIGHT_TRIANGLE;
    if (triangle) { // uniform on the triangle
        const float root = sqrt(xi.x);
        a = 1.0f - root;
        b = root * xi.y;
    }
    const float3 point = light->position.xyz + a * light->u.xyz + b * light->v.xyz, to = point - position;
    sample->distance = length3(to);
    sample->direction = to * (1.0f / sample->distance);
    const float cosine = -dot(sample->direction, light->normal.xyz);
    if (!(cosine > 0.0f && sample->distance > 0.0f)) return false;
    sample->density = light_area_density(light, chance, sample->distance, cosine);
    // Off the surface by more than rounding of the point and of a ray's test from that far: some ulp of both.
    const float3 size = fabs(point);
    const float rounding = 1e-6f * (max(size.x, max(size.y, size.z)) + sample->distance);
    sample->target = point + rounding * light->normal.xyz;
    sample->radiance = light->radiance.xyz;
    if (triangle) {
        float2 uv = (float2)(0.0f);
        if (HAS(TEXTURES)) {
            const uint3 corner = vload3(light->primitive, scene->triangles);
            uv = (1.0f - a - b) * vload2(corner.x, scene->uvs) + a * vload2(corner.y, scene->uvs) +
                 b * vload2(corner.z, scene->uvs);
        }
        sample->radiance = light_emission(scene, object_of(scene, light->primitive), uv);
    }
    sample->radiance *= 1.0f / sample->density;
    return true;
}

// Draws a light and a direction to it as seen from `receiver`. `few`: strength_of_few. False: it does not light that point.
bool light_sample(const Scene *scene, Sampler sampler, const Receiver *receiver, float few, LightSample *sample) {
    const float3 position = receiver->position;
    global const Light *light = scene->lights;
    float2 xi;
    const float chance = light_choose(scene, sampler, receiver, few, &light, &xi);
    if (!(chance > 0.0f)) return false;
    if (HAS(ENVIRONMENT_IMAGE) && light->kind == LIGHT_ENVIRONMENT_IMAGE) {
        sample->distance = MAXFLOAT;
        sample->direction = environment_sample(scene, light, draw_words(sampler, DRAW_TEXEL), xi, &sample->radiance,
                                               &sample->density);
        sample->density *= chance;
        if (!(sample->density > 0.0f)) return false;
        sample->radiance *= 1.0f / sample->density;
        return true;
    }
    if (HAS(DELTA_LIGHT) && light->kind == LIGHT_DIRECTIONAL) {
        sample->distance = MAXFLOAT;
        sample->direction = light->u.xyz;
        sample->radiance = light->radiance.xyz * (1.0f / chance);
        sample->density = 0.0f;
        return true;
    }
    if (HAS(DELTA_LIGHT) && light->kind == LIGHT_POINT) {
        const float3 to = light->position.xyz - position;
        const float distance2 = dot(to, to);
        if (!(distance2 > 0.0f)) return false;
        sample->distance = sqrt(distance2);
        sample->target = light->position.xyz;
        sample->direction = to * (1.0f / sample->distance);
        sample->radiance = light->radiance.xyz * (1.0f / (distance2 * chance));
        sample->density = 0.0f;
        return true;
    }
    if (HAS(RECT) || HAS(EMISSION)) return light_sample_flat(scene, light, chance, xi, position, sample);
    return false;
}

// What a ray that leaves the scene finds. `density`: of the BSDF that chose its direction at `receiver`, < 0: lights were not
// sampled there, so this is the only way (the camera's rays: then `camera` asks for what it may see).
float3 light_of_sky(const Scene *scene, const Receiver *receiver, float3 direction, float density, bool camera) {
    float3 sum = (float3)(0.0f);
    if (!(HAS(ENVIRONMENT) || HAS(ENVIRONMENT_IMAGE))) return sum;
    for (uint i = 0; i < scene->frame->environment_count; ++i) {
        global const Light *light = scene->lights + i;
        if (camera && !light->visible) continue;
        if (HAS(ENVIRONMENT_IMAGE) && light->kind == LIGHT_ENVIRONMENT_IMAGE) {
            const float2 at = environment_coordinates(light, direction);
            float weight = 1.0f;
            if (density >= 0.0f)
                weight = light_weight(density, light_chance(scene, light, receiver) * environment_density(scene, light, at));
            sum += environment_image(scene, light, at) * weight;
        } else {
            sum += light->radiance.xyz;
        }
    }
    return sum;
}

// Rects on the way from `receiver`, up to t_max. They emit to one side and block nothing.
float3 light_of_rects(const Scene *scene, const Receiver *receiver, float3 direction, float t_max, float density,
                      bool camera) {
    float3 sum = (float3)(0.0f);
    if (!HAS(RECT)) return sum;
    for (uint i = 0; i < scene->frame->rect_count; ++i) {
        global const Light *light = scene->lights + scene->frame->rect_first + i;
        const float cosine = -dot(direction, light->normal.xyz);
        if ((camera && !light->visible) || !(cosine > 0.0f)) continue;
        const float3 from = receiver->position - light->position.xyz;
        const float t = dot(from, light->normal.xyz) / cosine;
        if (!(t > 0.0f && t < t_max)) continue;
        const float3 at = from + t * direction, u = light->u.xyz, v = light->v.xyz;
        const float uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), au = dot(at, u), av = dot(at, v);
        const float inverse = 1.0f / (uu * vv - uv * uv);
        const float a = (au * vv - av * uv) * inverse, b = (av * uu - au * uv) * inverse;
        if (!(a >= 0.0f && a <= 1.0f && b >= 0.0f && b <= 1.0f)) continue;
        float weight = 1.0f;
        if (density >= 0.0f)
            weight = light_weight(density, light_area_density(light, light_chance(scene, light, receiver), t, cosine));
        sum += light->radiance.xyz * weight;
    }
    return sum;
}

// Light of an emitting triangle that a ray from `receiver` hit from its counter-clockwise side, after `distance`.
float3 light_of_surface(const Scene *scene, const Receiver *receiver, uint primitive, uint object, float2 uv, float distance,
                        float cosine, float density) {
    const uint first = scene->objects[object].first_light;
    if (first == NO_LIGHT || !(cosine > 0.0f)) return (float3)(0.0f);
    const float3 emission = light_emission(scene, object, uv);
    if (density < 0.0f) return emission;
    global const Light *light = scene->lights + first + (primitive - scene->objects[object].first_primitive);
    return emission *
           light_weight(density, light_area_density(light, light_chance(scene, light, receiver), distance, cosine));
}

#endif
