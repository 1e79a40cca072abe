// The whole path: camera, surfaces, walks, lights.
#ifndef NACRE_PATH_PATH_H
#define NACRE_PATH_PATH_H

#include "camera/camera.h"
#include "diffusion/diffusion.h"
#include "path/highlight.h"

// Paths past this many surface hits play Russian roulette with their largest throughput.
#ifndef PATH_ROULETTE_START
#define PATH_ROULETTE_START 3u
#endif

// The least share of the paths that an interface lets through which go through it.
#define PATH_LEAST_BASE 0.5f

// Colours that are darker need not be as exact for what they are. Also keeps black ones from dividing by 0.
#define PATH_LEAST_COLOR 0.01f

// Samples of a pixel, from an even one on, that share a camera ray: traced once, it serves the walks of both, which most noise is
// of: relative variance is .97 to 1.0 of what it was at 16 to 32 samples. But what the position in the pixel alone decides is twice
// as noisy: slivers lit from behind, in small pictures. Adaptive renders take samples for independent, and would not see that.
#ifndef CAMERA_RAY_SAMPLES
#ifdef TILE_LIST
#define CAMERA_RAY_SAMPLES 1u
#else
#define CAMERA_RAY_SAMPLES 2u
#endif
#endif

// Which pixel of the whole image is at `index` of the tile order; false: beyond the crop's edge.
bool pixel_at(const Scene *scene, uint index, uint *x, uint *y) {
    global const Frame *frame = scene->frame;
    const uint columns = (frame->crop_width + TILE - 1u) / TILE, tile = index / (TILE * TILE), at = index % (TILE * TILE);
    const uint cx = (tile % columns) * TILE + at % TILE, cy = (tile / columns) * TILE + at / TILE;
    *x = frame->crop_x + cx;
    *y = frame->crop_y + cy;
    return cx < frame->crop_width && cy < frame->crop_height;
}

// A path without its camera ray.
void path_begin(const Scene *scene, PATH_SPACE Path *path, uint x, uint y, uint sample, uint slot) {
    path->slot = slot;
    path->pixel = y * scene->frame->width + x;
    path->sample = sample;
    path->vertex = path->hits = 0u;
    path->state = PATH_RAY;
    path->throughput = (float4)(1.0f);
    path->radiance = (float4)(0.0f);
    path->weight = (float4)(0.0f);
    path->share = (float4)(0.0f);
    path->sigma = (float4)(0.0f);
    path->albedo = (float4)(0.0f);
    path->anisotropy = (float4)(0.0f);
    path->outward = (float4)(0.0f);
    path->bleed = path->first_number = path->thickness = path->far_light = 0.0f;
    path->object = path->flight = path->max_depth = path->channel = path->steps = path->depth = path->tries = 0u;
    path->foreseen = path->surplus = path->foreseen_across = path->surplus_across = (float4)(0.0f);
    path->scatters = path->twin = 0u; // all of it: a suspended path is copied whole
    path->key = sampler_key(scene->frame->seed, path->pixel, sample);
}

// Which of its pixel's camera rays a sample has. Behind a lens each has its own: what is out of focus is noise of the ray. So has
// each where walks have control variates: what is left is noise of the place in the pixel. The memo's head has .75 (g 0) and .88
// times (g .8) the relative variance for it, for 4 % more time.
uint camera_ray_of(const Scene *scene, uint sample) {
    if (HAS(LENS)) return sample;
    if (HAS(CONTROL) && scene->frame->lone_rays != 0u) return sample;
    return sample / CAMERA_RAY_SAMPLES;
}

bool path_shares_ray(const Scene *scene, const PATH_SPACE Path *path, const PATH_SPACE Path *other) {
    return path->pixel == other->pixel && camera_ray_of(scene, path->sample) == camera_ray_of(scene, other->sample);
}

// The path's camera ray, through pixel (x, y).
void path_aim(const Scene *scene, PATH_SPACE Path *path, uint x, uint y) {
    const Sampler sampler = sampler_with(path->key, camera_ray_of(scene, path->sample), 0u);
    const float2 lens = HAS(LENS) ? draw_pair(sampler, DRAW_LENS) : (float2)(0.0f);
    float3 origin, direction;
    camera_ray(scene, x, y, draw_pair(sampler, DRAW_PIXEL), lens, &origin, &direction);
    path->position = (float4)(origin, 0.0f);
    path->direction = (float4)(direction, -1.0f);
}

// What lies below the reflecting layer: its colour; w: how much of it is a medium.
float4 base_at(const Scene *scene, global const Material *material, float2 uv) {
    const float3 color = material_color(scene, material, PARAMETER_base_color, uv);
    if (!HAS(SUBSURFACE)) return (float4)(color, 0.0f);
    const float subsurface = material_number(scene, material, PARAMETER_subsurface_weight, uv);
    return (float4)(mix(color, material_color(scene, material, PARAMETER_subsurface_color, uv), subsurface), subsurface);
}

// Layers of the first surface: its colour, distance, normal.
void path_describe(const Scene *scene, global const Material *material, const Surface *surface, float distance,
                   global float4 *layers) {
    layers[0] = (float4)(base_at(scene, material, surface->uv).xyz, distance);
    layers[1] = (float4)(surface->shading, 0.0f);
}

// The reflecting layer of a material at a point. False: it has none.
bool specular_at(const Scene *scene, global const Material *material, const Surface *surface, float3 view,
                 Specular *specular) {
    const float2 uv = surface->uv;
    const float weight = material_number(scene, material, PARAMETER_specular_weight, uv);
    specular->metalness = material_number(scene, material, PARAMETER_base_metalness, uv);
    if (weight <= 0.0f && specular->metalness <= 0.0f) return false;
    specular->alpha = microfacet_alpha(material_number(scene, material, PARAMETER_specular_roughness, uv));
    specular->eta = weighted_ior(material_number(scene, material, PARAMETER_specular_ior, uv), weight);
    specular->metal = material_color(scene, material, PARAMETER_base_color, uv);
    specular->geometric = surface->geometric;
    specular->normal = seen_normal(surface->shading, view);
    float3 t, b;
    basis(specular->normal, &t, &b);
    specular->view = (float3)(dot(view, t), dot(view, b), dot(view, specular->normal));
    return true;
}

// The chance to reflect a path that meets the microfacet's reflectance `reflected`, where `let_through` gets to the base: the
// largest channel of `reflected`, so that no weight grows; more at the first surface, if the variance against the colour
// that shows is less then, supposing that both lead to the same light: a dark channel's highlights, which are most of
// its light, are not left to rare paths.
float reflection_chance(const PATH_SPACE Path *path, float3 reflected, float let_through, float4 base) {
    const float least = min(1.0f, largest3(reflected));
    if (path->hits > 1u || !(least > 0.0f)) return least;
    const float3 returned = let_through * base.xyz, shown = reflected + returned + PATH_LEAST_COLOR;
    // What a medium returns is noisy, unless it is white: up to twice its mean.
    const float noise = 1.0f + base.w * (1.0f - min(1.0f, min(base.x, min(base.y, base.z))));
    const float a = length3(reflected / shown), b = noise * length3(returned / shown);
    // A dark medium may be bright where it is thin.
    return max(least, min(a / (a + b), 1.0f - PATH_LEAST_BASE * let_through));
}

// Reflects the path, or lets it through to the base, see base_at, with what is left for that. xi in (0, 1) decides.
bool path_reflect(PATH_SPACE Path *path, const Specular *specular, float4 below, float2 xi_microfacet, float xi) {
    float3 direction;
    float base;
    const float3 r = specular_sample(specular, xi_microfacet, &direction, &base);
    const float chance = reflection_chance(path, r, base, below);
    if (xi >= chance) {
        path->throughput.xyz *= base / (1.0f - chance);
        return false;
    }
    path->throughput.xyz *= r * (1.0f / chance);
    path->direction = (float4)(direction, specular_density(specular_eval(specular, direction)));
    return true;
}

// Draws what happens at a surface: reflection, diffuse scattering, or entry. Returns its direct light.
Shadow path_scatter(const Scene *scene, PATH_SPACE Path *path, global const Material *material, const Surface *surface, float3 view,
                  Counts *counts) {
    const Sampler sampler = path_sampler(path);
    const float2 lobe = draw_pair(sampler, DRAW_LOBE);
    LightSample sample;
    const uint twin = HAS(CONTROL) ? control_twin(scene, path, surface) : TWIN_NONE;
    const bool foresees = HAS(CONTROL) && control_sees_near(scene, surface, twin);
    Specular specular;
    const bool shiny = HAS(SPECULAR) && specular_at(scene, material, surface, view, &specular);
    const float4 base = shiny ? base_at(scene, material, surface->uv) : (float4)(0.0f);
    const uint candidates = shiny && path->hits == 1u ? highlight_candidates(scene, &specular, surface->position, view) : 1u;
    const bool lit = (HAS(SPECULAR) || HAS(DIFFUSE) || foresees) && scene_samples_lights(scene) &&
                     highlight_sample(scene, sampler, surface, &specular, largest3(base.xyz) + PATH_LEAST_COLOR, candidates,
                                      &sample) &&
                     dot(sample.direction, surface->geometric) > 0.0f;
    float3 direct = (float3)(0.0f), foreseen = (float3)(0.0f);
    bool reflected = false;
    if (shiny) {
        if (lit) {
            const float3 r = specular_eval(&specular, sample.direction);
            direct += path->throughput.xyz * r * light_share(&sample, specular_density(r));
        }
        reflected = path_reflect(path, &specular, base, draw_pair(sampler, DRAW_MICROFACET), lobe.x);
    }
    if (!reflected) {
        const float subsurface =
            HAS(SUBSURFACE) ? material_number(scene, material, PARAMETER_subsurface_weight, surface->uv) : 0.0f;
        if (HAS(SUBSURFACE) && lobe.y < subsurface) {
            if (HAS(DIFFUSION_MODEL) && material->model != MODEL_RANDOM_WALK)
                diffusion_enter(scene, path, material, surface, counts);
            else
                path_enter(scene, path, sampler, surface, twin, counts);
            if (foresees && lit && path->state == PATH_WALK) foreseen = control_light(path, surface, &sample);
        } else {
            path->throughput.xyz *= material_color(scene, material, PARAMETER_base_color, surface->uv);
            path->direction.xyz = lambert_sample(draw_pair(sampler, DRAW_DIRECTION), surface->shading, surface->geometric);
            path->direction.w = lambert_pdf(path->direction.xyz, surface->shading, surface->geometric);
            if (lit) {
                const float pdf = lambert_pdf(sample.direction, surface->shading, surface->geometric);
                direct += path->throughput.xyz * pdf * light_share(&sample, pdf);
            }
        }
    }
    path->vertex += 1u;
    if (path->state == PATH_RAY) {
        path->position.xyz = offset_point(surface->position, surface->error, surface->geometric, path->direction.xyz);
        path->outward.xyz = surface->geometric;
        path->direction.w /= (float)candidates; // for the balance with so many draws of lights
    }
    if (!lit) return no_shadow();
    Shadow shadow = shadow_of(surface->position, surface->error, surface->geometric, &sample, direct * sample.radiance);
    shadow.foreseen = foreseen;
    return shadow;
}

// Ends paths of little throughput, without bias.
void path_roulette(const Scene *scene, PATH_SPACE Path *path, Counts *counts) {
    const float heaviest = largest3(path->throughput.xyz);
    if (!isfinite(path->throughput.x + path->throughput.y + path->throughput.z)) {
        path->radiance.xyz = path->throughput.xyz; // it will be counted; going on might never end
        path->state = PATH_DONE;
        return;
    }
    if (path->hits < PATH_ROULETTE_START && heaviest > 0.0f) return;
    if (heaviest >= 1.0f) return;
    const Sampler sampler = path_sampler(path);
    if (draw_pair(sampler, DRAW_ROULETTE).x >= heaviest) {
        path_lose(path, counts, COUNTER_roulette);
        return;
    }
    path->throughput.xyz *= 1.0f / heaviest;
}

// What the path's ray met: adds the light it found and goes on from there. Returns the direct light of the surface that is yet
// to be asked for. `layers`: of this path. `met`: the hit's surface, `known` from a path with the same ray or found here.
Shadow path_meet(const Scene *scene, PATH_SPACE Path *path, Hit hit, Surface *met, bool known, Counts *counts,
                 global float4 *layers) {
    const Ray ray = path_ray(path->position.xyz, path->direction.xyz);
    counts->value[COUNTER_rays] += 1u;
    const bool camera = path->hits == 0u, missed = hit.block == BVH_NO_PRIMITIVE;
    const float density = path->direction.w;
    const Receiver receiver = receiver_at(ray.origin, path->outward.xyz);
    float3 light = light_of_rects(scene, &receiver, ray.direction, missed ? MAXFLOAT : hit.t, density, camera);
    const bool last = scene->frame->max_depth != 0u && path->hits >= scene->frame->max_depth;
    if (missed || (last && !HAS(EMISSION))) { // else what the surface is like matters
        if (missed) light += light_of_sky(scene, &receiver, ray.direction, density, camera);
        path->radiance.xyz += path->throughput.xyz * light;
        path->state = PATH_DONE;
        return no_shadow();
    }
    if (!known) *met = surface_at(scene, ray, hit);
    Surface surface = *met;
    if (HAS(EMISSION))
        light += light_of_surface(scene, &receiver, surface.primitive, surface.object, surface.uv, hit.t,
                                  -dot(ray.direction, surface.geometric), density);
    path->radiance.xyz += path->throughput.xyz * light;
    if (dot(ray.direction, surface.geometric) > 0.0f) { // both sides look alike: normals face the viewer
        surface.geometric = -surface.geometric;
        surface.shading = -surface.shading;
    }
    global const Material *material = scene->materials + scene->objects[surface.object].material;
    if (camera) {
        path->radiance.w = 1.0f;
        if (HAS(SURFACE_AOV)) path_describe(scene, material, &surface, hit.t, layers);
    }
    if (last) {
        path->state = PATH_DONE;
        return no_shadow();
    }
    path->hits += 1u;
    const Shadow shadow = path_scatter(scene, path, material, &surface, -ray.direction, counts);
    path_roulette(scene, path, counts);
    return shadow;
}

#endif
