// Which light a point asks. Few of them are weighed one by one by what they may bring to the point, many drawn by their power
// from a table. Either way a light that may bring anything has a chance.
#ifndef NACRE_LIGHT_CHOICE_H
#define NACRE_LIGHT_CHOICE_H

#include "random/sampler.h"
#include "shared/view.h"

#pragma OPENCL FP_CONTRACT OFF

// So many lights are few.
#ifndef LIGHT_FEW
#define LIGHT_FEW 16u
#endif

// What is added to the cosine at the surface, which reflects by other laws than Lambert's too; and, in radii of a light, to the
// height above it, for points so near that its centre says little.
#define LIGHT_LEAST_COSINE 0.1f
#define LIGHT_NEAR 0.5f

// Where light arrives.
typedef struct {
    float3 position;
    float3 normal; // unit, geometric: no light comes from below
} Receiver;

Receiver receiver_at(float3 position, float3 normal) {
    Receiver receiver;
    receiver.position = position;
    receiver.normal = normal;
    return receiver;
}

float receiver_cosine(float height, float distance) {
    return height > 0.0f ? height / distance + LIGHT_LEAST_COSINE : 0.0f;
}

// The mean height over a flat light of what is above the surface, as if its heights were evenly spread.
float mean_height_above(float lowest, float highest) {
    if (!(highest > 0.0f)) return 0.0f;
    return lowest < 0.0f ? 0.5f * highest * (highest / (highest - lowest)) : 0.5f * (lowest + highest);
}

float strength_of_flat(global const Light *light, const Receiver *receiver) {
    const bool triangle = light->kind == LIGHT_TRIANGLE;
    const float3 u = light->u.xyz, v = light->v.xyz, from = light->position.xyz - receiver->position;
    const float above = -dot(light->normal.xyz, from), height = dot(receiver->normal, from);
    if (!(above > 0.0f)) return 0.0f;
    const float hu = dot(receiver->normal, u), hv = dot(receiver->normal, v);
    const float up = max(0.0f, triangle ? max(hu, hv) : max(0.0f, hu) + max(0.0f, hv));
    const float down = min(0.0f, triangle ? min(hu, hv) : min(0.0f, hu) + min(0.0f, hv));
    const float3 to = from + (triangle ? 1.0f / 3.0f : 0.5f) * (u + v);
    const float radius2 = INV_PI * light->normal.w, distance2 = dot(to, to) + radius2, distance = sqrt(distance2);
    const float cosine = receiver_cosine(mean_height_above(height + down, height + up), distance);
    return light->probability * cosine * (above + LIGHT_NEAR * sqrt(radius2)) / (distance * distance2);
}

// About the irradiance that a light brings to a point that sees it, times a factor that all lights share: their power, of which
// `probability` is the share, is pi x area x radiance, 4 pi x intensity, or of lights far away what a disk of radius 1/2 gets.
// Not 0 unless it brings nothing.
float light_strength(const Scene *scene, global const Light *light, const Receiver *receiver) {
    if (HAS(ENVIRONMENT_IMAGE) && light->kind == LIGHT_ENVIRONMENT_IMAGE) return light->probability; // on average
    if (HAS(DELTA_LIGHT) && light->kind == LIGHT_DIRECTIONAL)
        return 4.0f * light->probability * receiver_cosine(dot(receiver->normal, light->u.xyz), 1.0f);
    if (HAS(DELTA_LIGHT) && light->kind == LIGHT_POINT) {
        const float3 to = light->position.xyz - receiver->position;
        const float distance2 = dot(to, to);
        if (!(distance2 > 0.0f)) return 0.0f;
        return 0.25f * light->probability * receiver_cosine(dot(receiver->normal, to), sqrt(distance2)) / distance2;
    }
    if (HAS(RECT) || HAS(EMISSION)) return light->probability > 0.0f ? strength_of_flat(light, receiver) : 0.0f;
    return 0.0f;
}

// Of few lights the strength of all. 0: they are many, or none brings anything.
float strength_of_few(const Scene *scene, const Receiver *receiver) {
    float sum = 0.0f;
    if (scene->frame->light_count > LIGHT_FEW) return sum;
    for (uint i = 0; i < scene->frame->light_count; ++i) sum += light_strength(scene, scene->lights + i, receiver);
    return sum;
}

// Draws a light, and two numbers in (0, 1) for a point on it; `few`: strength_of_few. Returns its chance; 0: none brings
// anything. Of few lights the number that draws one goes on to draw the point, so that the points on each are as even as the
// pairs are: points of pairs of their own are a random choice from even ones, and the memo's head is 1.1 times as noisy with
// them (plain variance, 32 samples).
float light_choose(const Scene *scene, Sampler sampler, const Receiver *receiver, float few, global const Light **chosen,
                   float2 *point) {
    const uint count = scene->frame->light_count;
    const uint2 words = draw_words(sampler, DRAW_LIGHT);
    if (count > LIGHT_FEW) {
        const uint slot = mul_hi(words.x, count);
        const AliasEntry entry = scene->light_table[slot];
        *chosen = scene->lights + (random_unit(words.y) < entry.threshold ? slot : entry.other);
        *point = draw_pair(sampler, DRAW_LIGHT_POINT);
        return (*chosen)->probability;
    }
    float rest = random_unit(words.x) * few, last = 0.0f;
    for (uint i = 0; i < count; ++i) {
        const float strength = light_strength(scene, scene->lights + i, receiver);
        if (!(strength > 0.0f)) continue;
        *chosen = scene->lights + i;
        last = strength;
        *point = (float2)(clamp(rest / strength, 0x1p-24f, 0x1.fffffep-1f), random_unit(words.y));
        rest -= strength;
        if (rest < 0.0f) break; // else rounding: the last one
    }
    return last > 0.0f ? last / few : 0.0f;
}

// The chance that light_choose draws `light`.
float light_chance(const Scene *scene, global const Light *light, const Receiver *receiver) {
    if (scene->frame->light_count > LIGHT_FEW) return light->probability;
    const float strength = light_strength(scene, light, receiver);
    return strength > 0.0f ? strength / strength_of_few(scene, receiver) : 0.0f;
}

#endif
