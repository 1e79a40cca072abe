// A path below a surface with a diffusion model: one of its lobes is drawn, and the path leaves as a Lambertian vertex, as a
// walk does.
#ifndef NACRE_DIFFUSION_DIFFUSION_H
#define NACRE_DIFFUSION_DIFFUSION_H

#include "diffusion/medium.h"
#include "diffusion/probe.h"
#include "diffusion/straight.h"

// Least chance of the lobe of zero and single scattering: how much goes straight through a thin body the totals do not say.
#ifndef STRAIGHT_CHANCE
#define STRAIGHT_CHANCE 0.25f
#endif

float straight_chance(int model, float3 single, float3 multiple) {
    if (model == MODEL_BURLEY) return 0.0f;
    const float s = single.x + single.y + single.z, m = multiple.x + multiple.y + multiple.z;
    return m > 0.0f ? max(STRAIGHT_CHANCE, s / (s + m)) : 1.0f;
}

// Channels draw in proportion to the light that the path would bring back through them.
void probe_chances(ProbeProfiles *profiles, float3 light) {
    const float sum = light.x + light.y + light.z;
    profiles->chance[0] = light.x / sum;
    profiles->chance[1] = light.y / sum;
    profiles->chance[2] = light.z / sum;
}

// A line's crossing of the object's outside, of all of them the one that was drawn.
typedef struct {
    Surface surface;
    float3 weight;
    float light, all; // what it brings, and all together
} Crossing;

// Counts shells from the line's begin, outside: from 0 to 1 and from 1 to 0 the outside is crossed. An open mesh has none, there
// every crossing counts.
bool probe_crosses(bool closed, bool front, int *depth) {
    const int before = *depth;
    *depth += front ? 1 : -1;
    return !closed || (front ? before == 0 : *depth == 0);
}

// Draws a crossing of `line` in proportion to the light it brings. Returns false where there is none.
bool probe_surface(const Scene *scene, const PATH_SPACE Path *path, Sampler sampler, const ProbeProfiles *profiles,
                   const ProbeFrame *frame, ProbeLine line, Crossing *crossing, Counts *counts) {
    global const Object *object = scene->objects + path->object;
    const float3 entry = path->position.xyz, along = probe_world(frame, line.along);
    const float before = 2.1f * scene->frame->scene_radius; // of the entry: outside of everything
    if (!(length3(line.across) < before)) return false;      // past everything
    Ray ray = path_ray(entry + probe_world(frame, line.across) - before * along, along);
    crossing->all = 0.0f;
    int depth = 0;
    for (uint i = 0u;; ++i) {
        counts->value[COUNTER_walk_rays] += 1u;
        const Hit hit = trace_closest(ray, scene->nodes, scene->blocks,
                                      object->walk_root AND_PROFILED(counts->profile + PROFILE_walk_nodes));
        if (hit.block == BVH_NO_PRIMITIVE) return crossing->all != 0.0f;
        ray.t_min = hit.t;
        const Surface surface = surface_at(scene, ray, hit);
        if (!probe_crosses(object->closed != 0u, dot(surface.geometric, along) < 0.0f, &depth)) continue;
        // Along the line the offset is as exact as positions are, which is nothing in a medium dense enough: a plane stays one.
        float height = dot(surface.position - entry, along);
        const float rounding = surface.error.x + surface.error.y + surface.error.z;
        height = fabs(height) < rounding ? 0.0f : height;
        const float3 normal = (float3)(dot(surface.geometric, frame->tangent), dot(surface.geometric, frame->bitangent),
                                       dot(surface.geometric, frame->normal));
        const float3 weight = path->share.xyz * probe_weight(profiles, line.across + height * line.along, normal);
        const float3 brought = path->throughput.xyz * weight;
        const float light = brought.x + brought.y + brought.z, xi = random_unit(draw_bits(sampler, DRAW_WALK, i).x);
        crossing->all += light;
        if (xi * crossing->all >= light) continue; // NaN does not go on: it has to show
        crossing->surface = surface;
        crossing->weight = weight;
        crossing->light = light;
    }
}

// Multiple scattering, times `scale`.
Shadow probe_leave(const Scene *scene, PATH_SPACE Path *path, int model, Sampler sampler, float xi_channel, float scale,
                   Counts *counts) {
    const float3 light = path->throughput.xyz * path->share.xyz;
    const float3 g = path->anisotropy.xyz;
    ProbeProfiles profiles;
    profiles.channel[0] = profile_of(model, path->sigma.x, path->albedo.x, g.x, path->share.x);
    profiles.channel[1] = profile_of(model, path->sigma.y, path->albedo.y, g.y, path->share.y);
    profiles.channel[2] = profile_of(model, path->sigma.z, path->albedo.z, g.z, path->share.z);
    probe_chances(&profiles, light);
    const uint channel =
        xi_channel < profiles.chance[0] ? 0u : xi_channel < profiles.chance[0] + profiles.chance[1] ? 1u : 2u;
    const float2 pair = draw_pair(sampler, DRAW_ENTRY);
    const ProbeFrame frame = probe_frame(-path->direction.xyz);
    const ProbeLine line = probe_line(profiles.channel + channel, pair.x, draw_pair(sampler, DRAW_FIRST).y, pair.y);
    Crossing crossing;
    if (!probe_surface(scene, path, sampler, &profiles, &frame, line, &crossing, counts)) {
        path_lose(path, counts, COUNTER_roulette); // it is one: others brought more for it
        return no_shadow();
    }
    path->weight.xyz = crossing.weight * (scale * crossing.all / crossing.light);
    const Surface surface = crossing.surface;
    return path_exit(scene, path, surface.position, surface.error, surface.shading, surface.geometric);
}

// Brings a path of state PATH_PROBE back to the surface, or to its end. Returns the direct light of its exit that is yet to be
// asked for.
Shadow diffusion_leave(const Scene *scene, PATH_SPACE Path *path, Counts *counts) {
    const Sampler sampler = path_sampler(path);
    const int model = scene->materials[scene->objects[path->object].material].model;
    const float chance = straight_chance(model, path->weight.xyz, path->share.xyz);
    const float xi = draw_pair(sampler, DRAW_FIRST).x;
    if (xi < chance)
        return straight_walk(scene, path, sampler, min((uint)(3.0f * xi / chance), 2u), 1.0f / chance, counts);
    return probe_leave(scene, path, model, sampler, (xi - chance) / (1.0f - chance), 1.0f / (1.0f - chance), counts);
}

#endif
