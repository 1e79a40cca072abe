// A medium below a dielectric interface: how a path gets in through it, and how it keeps walks in.
//
// Entry `refracted`. The specular layer draws a microfacet and reflects r of the path; else the path enters, refracted by the
// same facet. So r + (1 - r) = 1 facet by facet, whatever the chance of each: what is reflected is taken off where it was
// reflected, not by an average over the facets. Light that facets send on to one another is not followed; it enters as well, and a
// furnace stays 1 at every roughness.
//
// Reflection inside. The interface is smooth there (what walks have scattered is spread over all directions already) and lies in
// the plane of the geometric normal, which alone says what inside is. A walk is turned back with Fresnel's chance, else it
// leaves, lit with Lambert's response as without an interface. So weights do not change and a furnace stays 1. A refracted exit
// would meet no point or directional light; Lambert's has the same flux on average: of light from all sides
// 1 - (average external reflectance) = eta^2 (1 - average internal reflectance) gets through.
#ifndef NACRE_PATH_INTERFACE_H
#define NACRE_PATH_INTERFACE_H

#include "bsdf/material.h"
#include "bsdf/refraction.h"
#include "bsdf/specular.h"
#include "geometry/surface.h"
#include "random/sampler.h"

// Direction of the entry of a path that meets `surface`, which faces it.
float3 interface_enter(const Scene *scene, global const Material *material, const Surface *surface, const PATH_SPACE Path *path,
                       Sampler sampler) {
    const float3 view = -path->direction.xyz;
    const float alpha = microfacet_alpha(material_number(scene, material, PARAMETER_specular_roughness, surface->uv));
    const float eta = material_number(scene, material, PARAMETER_specular_ior, surface->uv);
    return refracted_entry(view, seen_normal(surface->shading, view), surface->geometric, alpha, eta,
                           draw_pair(sampler, DRAW_MICROFACET));
}

// Turns a walk that flew along `direction` to the surface of its object back inside, or lets it out (false). The walk's next
// flight begins at the surface, as its first did. It needs numbers of its own: the draws of an entry are free at this vertex.
bool interface_holds(const Scene *scene, const Surface *surface, float3 direction, PATH_SPACE Path *path) {
    global const Material *material = scene->materials + scene->objects[surface->object].material;
    if (material->internal_reflection == 0) return false;
    const float eta = material_number(scene, material, PARAMETER_specular_ior, surface->uv);
    const float weight = material_number(scene, material, PARAMETER_specular_weight, surface->uv);
    const float cosine = clamp(dot(direction, surface->geometric), 0.0f, 1.0f);
    const Sampler sampler = path_sampler(path);
    if (draw_pair(sampler, DRAW_LOBE).x >= fresnel_inside(cosine, eta, weighted_ior(eta, weight))) return false;
    path->position.xyz = surface->position;
    path->direction.xyz = unfold(direction, surface->geometric);
    path->first_number = draw_pair(sampler, DRAW_FIRST).y;
    path->scatters += path->steps;
    if (path->max_depth != 0u) path->max_depth -= path->steps; // some are left, else it had been capped
    path->steps = 0u;
    path->depth = 1u;
    path->vertex += 1u;
    return true;
}

#endif
