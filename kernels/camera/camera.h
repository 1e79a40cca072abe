// Rays from the camera. Perspective with a thin lens, or orthographic.
#ifndef NACRE_CAMERA_CAMERA_H
#define NACRE_CAMERA_CAMERA_H

#include "lanes/math.h"
#include "lanes/scalar.h"
#include "random/sampler.h"
#include "sampling/hemisphere.h"
#include "shared/view.h"

// xi: where in the pixel (x, y of the whole image); lens: a point of the unit square.
void camera_ray(const Scene *scene, uint x, uint y, float2 xi, float2 lens, float3 *origin, float3 *direction) {
    global const Frame *frame = scene->frame;
    global const Camera *camera = &frame->camera;
    const float sx = (2.0f * ((float)x + xi.x) / (float)frame->width - 1.0f) * camera->half_width;
    const float sy = (1.0f - 2.0f * ((float)y + xi.y) / (float)frame->height) * camera->half_height;
    const float3 right = camera->right.xyz, up = camera->up.xyz, forward = camera->forward.xyz;
    *origin = camera->position.xyz;
    if (camera->kind == CAMERA_ORTHOGRAPHIC) {
        *origin += sx * right + sy * up;
        *direction = forward;
        return;
    }
    float3 to = sx * right + sy * up + forward;
    if (HAS(LENS)) { // through the same point of the plane in focus
        float s, c;
        sincos_scalar(lens.y, &s, &c);
        const float r = camera->lens_radius * sqrt(lens.x);
        const float3 shift = (r * c) * right + (r * s) * up;
        *origin += shift;
        to -= shift * (1.0f / camera->focus_distance);
    }
    *direction = unit3(to);
}

#endif
