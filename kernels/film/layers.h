// What a path keeps for the picture's layers until the film takes it, float4 each: two of its first surface (SURFACE_AOV), then
// one of its first walk (SCATTER_AOV): the radiance that it had when that walk ended, and how often the walk scattered (w, < 0:
// it has not walked). All that it finds later came through that walk.
#ifndef NACRE_FILM_LAYERS_H
#define NACRE_FILM_LAYERS_H

#include "shared/view.h"

uint layers_of_surface(const Scene *scene) { return HAS(SURFACE_AOV) ? LAYERS_SURFACE : 0u; }

uint layers_each(const Scene *scene) { return layers_of_surface(scene) + (HAS(SCATTER_AOV) ? LAYERS_SCATTER : 0u); }

// As if the path had never walked.
void layers_unwalked(const Scene *scene, global float4 *layers) {
    layers[layers_of_surface(scene)] = (float4)(0.0f, 0.0f, 0.0f, -1.0f);
}

// Of a path that has met nothing.
void layers_begin(const Scene *scene, global float4 *layers) {
    if (HAS(SURFACE_AOV)) layers[0] = layers[1] = (float4)(0.0f);
    if (HAS(SCATTER_AOV)) layers_unwalked(scene, layers);
}

// A walk of the path ended, with `radiance` found so far.
void layers_walked(const Scene *scene, global float4 *layers, float3 radiance, uint scatters) {
    global float4 *walk = layers + layers_of_surface(scene);
    if (walk->w < 0.0f) *walk = (float4)(radiance, (float)scatters);
}

#endif
