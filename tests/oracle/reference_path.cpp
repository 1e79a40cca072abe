#include "oracle/reference_path.h"
#include "oracle/reference_lobes.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace nacre::reference {

using namespace shared;

namespace {

/// The coat of a surface for one channel; nothing where it has none.
std::optional<Coat> coat_at(const World &world, const Surface &surface, const Vec3 &view, int channel) {
    const double weight = world.value(surface, PARAMETER_specular_weight);
    Coat coat;
    coat.metalness = world.value(surface, PARAMETER_base_metalness);
    if (weight <= 0 && coat.metalness <= 0) return {};
    coat.eta = weighted_ior(world.value(surface, PARAMETER_specular_ior), weight);
    coat.metal = world.value(surface, PARAMETER_base_color, channel);
    coat.alpha = std::max(1e-3, std::pow(world.value(surface, PARAMETER_specular_roughness), 2));
    coat.normal = seen_normal(surface.shading, view);
    coat.geometric = surface.geometric;
    coat.view = view;
    return coat;
}

} // namespace

double Path::trace(const Ray &first) {
    ray = first;
    for (std::uint32_t hits = 0; !ends; ++hits) {
        const std::optional<Hit> hit = world.all().closest(ray);
        const double end = hit ? hit->t : std::numeric_limits<double>::infinity();
        light += throughput * light_of_rects(world, ray, end, sees, channel);
        if (!hit) return light + throughput * light_of_environments(world, ray, sees, channel);
        Surface surface = world.surface(*hit);
        light += throughput * light_of_surface(world, surface, ray.direction, channel);
        if (hits == world.scene.render.max_depth && hits > 0) return light; // max_depth 0: no limit
        if (ray.direction.dot(surface.geometric) > 0) {                     // both sides look alike
            surface.geometric = -surface.geometric;
            surface.shading = -surface.shading;
        }
        scatter(surface, -ray.direction);
        if (!survives(throughput, random)) ends = true;
    }
    return light;
}

void Path::go(const Surface &surface, const Vec3 &direction, Sees what) {
    ray = {surface.position, direction, surface.triangle};
    sees = what;
}

void Path::scatter(const Surface &surface, const Vec3 &view) {
    const std::optional<Coat> coat = coat_at(world, surface, view, channel);
    Vec3 facet;
    if (coat) {
        const Lobe lobe = [&](const Vec3 &direction) { return coat->value(direction); };
        light += throughput * direct_light(world, surface, lobe, false, channel, random);
        if (reflect(surface, *coat, facet)) return;
    }
    if (random() < world.value(surface, PARAMETER_subsurface_weight))
        below(surface, entry(surface, view, coat ? &facet : nullptr));
    else
        diffuse(surface, world.value(surface, PARAMETER_base_color, channel));
}

// A facet reflects the path with the chance that it reflects light; the layer below gets what it does not, except under
// metal.
bool Path::reflect(const Surface &surface, const Coat &coat, Vec3 &facet) {
    const Facets facets = coat.facets();
    const Vec3 h = facets.draw(random);
    facet = about(coat.normal, h);
    const double cosine = facets.view.dot(h);
    const Vec3 mirrored_view = 2 * cosine * h - facets.view;
    const double both = mirrored_view.z() > 0 ? facets.seen_by_both(mirrored_view) : 0;
    const double chance = std::min(1.0, coat.reflectance(cosine) * both);
    if (random() < chance) {
        go(surface, folded(about(coat.normal, mirrored_view), surface.geometric), Sees::all);
        return true;
    }
    throughput *= (1 - coat.metalness) * (1 - coat.dielectric(cosine) * both) / (1 - chance);
    return false;
}

void Path::diffuse(const Surface &surface, double albedo) {
    throughput *= albedo;
    const Lobe lobe = [&](const Vec3 &direction) {
        return lambert_value(direction, surface.shading, surface.geometric);
    };
    light += throughput * direct_light(world, surface, lobe, true, channel, random);
    go(surface, lambert_direction(surface.shading, surface.geometric, random), Sees::not_asked);
}

Vec3 Path::entry(const Surface &surface, const Vec3 &view, const Vec3 *facet) {
    const Vec3 inner = -surface.geometric;
    switch (world.material(surface).entry) {
    case ENTRY_UNIFORM: return about(inner, uniform_direction(random));
    case ENTRY_REFRACTED: {
        const Vec3 normal = seen_normal(surface.shading, view);
        const double roughness = world.value(surface, PARAMETER_specular_roughness);
        const Facets facets{std::max(1e-3, roughness * roughness), seen_from(normal, view)};
        const Vec3 h = facet ? *facet : about(normal, facets.draw(random)); // that which has not reflected the path
        return folded(refracted(view, h, world.value(surface, PARAMETER_specular_ior)), inner);
    }
    case ENTRY_LAMBERT: break;
    }
    return about(inner, cosine_direction(random));
}

// A smooth interface in the plane of the geometric normal.
bool Path::turned_back(const Surface &surface, const Vec3 &direction) {
    if (!world.material(surface).internal_reflection) return false;
    const double ior = world.value(surface, PARAMETER_specular_ior);
    const double reflecting = weighted_ior(ior, world.value(surface, PARAMETER_specular_weight));
    return random() < fresnel_inside(std::max(0.0, direction.dot(surface.geometric)), ior, reflecting);
}

void Path::below(const Surface &surface, const Vec3 &inwards) {
    const std::uint32_t first = world.first_triangle(surface.object);
    const Medium medium = world.medium(surface, channel);
    Walk walk{{surface.position, inwards, surface.triangle - first}};
    for (;;) {
        std::optional<Hit> hit = walk.leave(world.body(surface.object), medium, random);
        if (!hit) {
            ends = true;
            return;
        }
        const std::uint32_t local = hit->triangle;
        hit->triangle += first;
        const Surface out = world.surface(*hit);
        if (!turned_back(out, walk.ray.direction)) {
            throughput *= walk.weight;
            return diffuse(out, 1);
        }
        walk.ray = {out.position, mirrored(walk.ray.direction, out.geometric), local};
    }
}

} // namespace nacre::reference
