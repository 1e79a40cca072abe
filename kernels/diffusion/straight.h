// Zero and single scattering, which the dipoles leave out (memo, section 2): a walk that is over after one scatter. Its first
// flight is drawn (hero: one channel, the balance heuristic over all), the second goes to the surface as it is and weighs what
// Beer's law leaves of it.
#ifndef NACRE_DIFFUSION_STRAIGHT_H
#define NACRE_DIFFUSION_STRAIGHT_H

#include "path/walk.h"

float3 beer(float3 sigma, float distance) {
    return (float3)(exp_scalar(-sigma.x * distance), exp_scalar(-sigma.y * distance), exp_scalar(-sigma.z * distance));
}

// Where a flight of `distance` leaves its object; else block is BVH_NO_PRIMITIVE. Rays as in turn_rays.
Hit straight_hit(const Scene *scene, const PATH_SPACE Path *path, Ray ray, uint *depth, Counts *counts) {
    const uint root = scene->objects[path->object].walk_root;
    for (;;) {
        counts->value[COUNTER_walk_rays] += 1u;
        const Hit hit = trace_hit(ray, scene->nodes, scene->blocks, root,
                                  MEET_FLIGHT AND_PROFILED(counts->profile + PROFILE_walk_nodes));
        if (hit.block == BVH_NO_PRIMITIVE || boundary_leaves(scene, hit, ray.direction, depth)) return hit;
        ray.t_min = hit.t;
    }
}

float3 phase_scalar(const Scene *scene, float g, uint4 words, float3 direction) {
    const real3 d = phase_sample(scene, (real)(g), (real)(random_unit(words.y)), (real)(random_unit(words.z)),
                                 real3_of(direction));
    return (float3)(LANE_FLOAT(d.x, 0u), LANE_FLOAT(d.y, 0u), LANE_FLOAT(d.z, 0u));
}

// Henyey-Greenstein's density of each channel, up to a factor.
float3 phase_densities(float3 g, float3 from, float3 to) {
    const float3 away = to - from, d = (1.0f - g) * (1.0f - g) + g * dot(away, away);
    return (1.0f - g * g) / (d * sqrt(d));
}

// Takes the path into the medium and out of it, times `scale`. Returns the direct light of its exit.
Shadow straight_walk(const Scene *scene, PATH_SPACE Path *path, Sampler sampler, uint channel, float scale, Counts *counts) {
    const float3 sigma = path->sigma.xyz;
    const float beyond = turn_beyond(scene);
    float3 position = path->position.xyz;
    float3 direction = to_world(cosine_hemisphere(draw_pair(sampler, DRAW_ENTRY)), path->direction.xyz);
    float distance = -log_scalar(draw_pair(sampler, DRAW_FIRST).y) /
                     (channel == 0u ? sigma.x : channel == 1u ? sigma.y : sigma.z);
    float3 weight = (float3)(scale), drawn = (float3)(1.0f);
    uint depth = 1u;
    for (uint flight = 0u;; ++flight) {
        counts->value[COUNTER_steps] += 1u;
        const float rounding =
            POSITION_ROUNDING * max(fabs(position.x), max(fabs(position.y), fabs(position.z)));
        distance = flight == 0u ? min(distance, beyond) : beyond;
        Ray ray = path_ray(position - rounding * direction, direction);
        ray.t_max = distance + 2.0f * rounding;
        const Hit hit = straight_hit(scene, path, ray, &depth, counts);
        const bool left = hit.block != BVH_NO_PRIMITIVE;
        if (left) distance = max(0.0f, hit.t - rounding);
        float3 density = beer(sigma, distance);
        if (flight == 0u) {
            density *= left ? (float3)(1.0f) : sigma;
            density *= 3.0f / (density.x + density.y + density.z);
            drawn = density;
            if (!left) density *= path->albedo.xyz;
        }
        weight *= density;
        path->weight.xyz = weight;
        if (left) {
            const Surface surface = surface_at(scene, ray, hit);
            return path_exit(scene, path, surface.position, surface.error, surface.shading, surface.geometric);
        }
        if (distance >= beyond) break;
        position += distance * direction;
        const float3 g = path->anisotropy.xyz, from = direction;
        const float drawn_g = channel == 0u ? g.x : channel == 1u ? g.y : g.z;
        direction = phase_scalar(scene, drawn_g, draw_bits(sampler, DRAW_WALK, 0u), direction);
        if (HAS(ANISOTROPY_RGB)) { // length and direction are drawn for one channel: their densities multiply
            const float3 phase = phase_densities(g, from, direction);
            weight *= phase * (3.0f / dot(drawn, phase));
        }
    }
    // As in lane_end: rounding, or a hole.
    if (!scene->objects[path->object].closed) {
        path_lose(path, counts, COUNTER_escaped);
        return no_shadow();
    }
    counts->value[COUNTER_missed] += 1u;
    return path_exit(scene, path, position, (float3)(0.0f), direction, direction);
}

#endif
