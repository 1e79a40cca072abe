// Adds the samples of a batch to the film: one work-item per pixel, in the order of the samples, so that the sum does not
// depend on how the batch was traced.
#ifndef NACRE_FILM_ACCUMULATE_H
#define NACRE_FILM_ACCUMULATE_H

#include "shared/view.h"

void film_accumulate(uint pixel, uint samples, uint slot, global const float4 *radiance, global const float4 *surface,
                     uint planes, global float4 *film) {
    global float4 *sum = film + pixel * planes;
    float4 total = sum[FILM_RADIANCE], square = sum[FILM_SQUARE];
    for (uint i = 0; i < samples; ++i) {
        const float4 value = radiance[slot + i];
        total += value;
        square += value * value;
    }
    sum[FILM_RADIANCE] = total;
    sum[FILM_SQUARE] = square;
    if (planes <= FILM_ALBEDO) return;
    float4 albedo = sum[FILM_ALBEDO], normal = sum[FILM_NORMAL];
    for (uint i = 0; i < samples; ++i) {
        albedo += surface[2u * (slot + i)];
        normal += surface[2u * (slot + i) + 1u];
    }
    sum[FILM_ALBEDO] = albedo;
    sum[FILM_NORMAL] = normal;
}

#endif
