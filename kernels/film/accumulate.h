// Adds the samples of a batch to the film: one work-item per pixel, in the order of the samples, so that the sum does not
// depend on how the batch was traced.
#ifndef NACRE_FILM_ACCUMULATE_H
#define NACRE_FILM_ACCUMULATE_H

#include "film/layers.h"
#include "lanes/scalar.h"

#pragma OPENCL FP_CONTRACT OFF

// `layers`: of the first sample's surface. `sum`: its planes.
void film_add_surface(uint samples, uint each, global const float4 *layers, global float4 *sum) {
    float4 albedo = sum[0], normal = sum[1];
    for (uint i = 0; i < samples; ++i) {
        albedo += layers[i * each];
        normal += layers[i * each + 1u];
    }
    sum[0] = albedo;
    sum[1] = normal;
}

// The light of a path is in one of the three layers, by how often its first walk scattered; that of one without a walk in none.
void film_add_scatter(uint samples, uint each, global const float4 *radiance, global const float4 *layers,
                      global float4 *sum) {
    float4 zero = sum[0], single = sum[1], multiple = sum[2];
    for (uint i = 0; i < samples; ++i) {
        const float4 walk = layers[i * each];
        if (walk.w < 0.0f) continue;
        const float3 light = radiance[i].xyz - walk.xyz;
        if (walk.w == 0.0f) zero.xyz += light;
        else if (walk.w == 1.0f) single.xyz += light;
        else multiple.xyz += light;
        zero.w += 1.0f;
        single.w += walk.w;
    }
    sum[0] = zero;
    sum[1] = single;
    sum[2] = multiple;
}

void film_accumulate(const Scene *scene, uint pixel, uint samples, uint slot, global const float4 *radiance,
                     global const float4 *layers, uint planes, global float4 *film) {
    global float4 *sum = film + pixel * planes;
    float4 total = sum[FILM_RADIANCE], square = sum[FILM_SQUARE], rest = sum[FILM_REST];
    for (uint i = 0; i < samples; ++i) {
        float4 value = radiance[slot + i];
        LISTED(const float cost = floor_scalar(value.w / LIST_COST);)
        LISTED(value.w -= LIST_COST * cost;)
        // Knuth's exact sum (The Art of Computer Programming 2, 4.2.2): next + its rest is total + value to the last bit.
        const float4 next = total + value, added = next - total;
        rest += (total - (next - added)) + (value - added);
        total = next;
        square += value * value;
        LISTED(square.w += cost - value.w * value.w;)
    }
    sum[FILM_RADIANCE] = total;
    sum[FILM_SQUARE] = square;
    sum[FILM_REST] = rest;
    const uint each = layers_each(scene), surface = layers_of_surface(scene);
    if (HAS(SURFACE_AOV)) film_add_surface(samples, each, layers + slot * each, sum + FILM_PLANES);
    if (HAS(SCATTER_AOV))
        film_add_scatter(samples, each, radiance + slot, layers + slot * each + surface,
                         sum + FILM_PLANES + (HAS(SURFACE_AOV) ? FILM_SURFACE_PLANES : 0u));
}

#endif
