// Lets a test draw lights as a path does, from a scene that the host has uploaded.
#include "light/light.h"
#include "shared/view.h"

// Draws seen from `position` with the normal `normal`, independent of each other. out, four float4 each: direction and distance (0: nothing drawn);
// radiance over density, and density; and for an image environment as light 0, looked up again from the direction:
// coordinates in texels and density; radiance.
kernel __attribute__((reqd_work_group_size(WORK_GROUP, 1, 1))) void probe_light(
    SCENE_PARAMETERS, float4 position, float4 normal, uint seed, uint count, global float4 *out) {
    Scene view = {SCENE_ARGUMENTS};
    const Scene *scene = &view;
    const uint i = get_global_id(0);
    if (i >= count) return;
    const Sampler sampler = sampler_of(seed, i, 0u, SOBOL_VERTICES);
    const Receiver receiver = receiver_at(position.xyz, normal.xyz);
    LightSample sample;
    const bool drawn = light_sample(scene, sampler, &receiver, strength_of_few(scene, &receiver), &sample);
    for (uint k = 0; k < 4u; ++k) out[4u * i + k] = (float4)(0.0f);
    if (!drawn) return;
    out[4u * i] = (float4)(sample.direction, sample.distance);
    out[4u * i + 1u] = (float4)(sample.radiance, sample.density);
    if (!HAS(ENVIRONMENT_IMAGE)) return;
    const float2 at = environment_coordinates(lights, sample.direction);
    out[4u * i + 2u] = (float4)(at, environment_density(scene, lights, at), 0.0f);
    out[4u * i + 3u] = (float4)(environment_image(scene, lights, at), 0.0f);
}
