// Direct light on a path's vertex: one light is drawn, one shadow ray asks whether it is seen.
#ifndef NACRE_PATH_LIGHT_H
#define NACRE_PATH_LIGHT_H

#include "bsdf/lambert.h"
#include "bsdf/specular.h"
#include "path/shadow.h"

bool scene_samples_lights(const Scene *scene) {
    return (HAS(ENVIRONMENT_IMAGE) || HAS(RECT) || HAS(EMISSION) || HAS(DELTA_LIGHT)) && scene->frame->light_count > 0u;
}

// Weight of a drawn light against the BSDF, which finds its direction with `pdf`.
float light_share(const LightSample *sample, float pdf) {
    return sample->density > 0.0f ? light_weight(sample->density, pdf) : 1.0f;
}

// Direct light on a Lambertian vertex (albedo in the throughput).
Shadow light_lambert(const Scene *scene, float3 throughput, Sampler sampler, float3 position, float3 error, float3 shading,
                     float3 geometric) {
    LightSample sample;
    const Receiver receiver = receiver_at(position, geometric);
    if (!scene_samples_lights(scene) || !light_sample(scene, sampler, &receiver, strength_of_few(scene, &receiver), &sample))
        return no_shadow();
    const float pdf = lambert_pdf(sample.direction, shading, geometric);
    if (!(pdf > 0.0f)) return no_shadow();
    return shadow_of(position, error, geometric, &sample,
                     throughput * sample.radiance * (pdf * light_share(&sample, pdf)));
}

#endif
