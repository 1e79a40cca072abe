#include "oracle/reference_lights.h"
#include <limits>

namespace nacre::reference {
namespace {

using namespace shared;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A rect in the lengths of the world.
struct Rect {
    Vec3 corner, u, v, normal;
    double area;

    Rect(const World &world, const scene::Light &light)
        : corner(world.units.point(light.position - (light.u + light.v) / 2)), u(world.units.vector(light.u)),
          v(world.units.vector(light.v)), normal(u.cross(v).normalized()), area(u.cross(v).norm()) {}

    /// Distance to it, infinite where the ray misses it or meets its dark side.
    double meet(const Ray &ray) const {
        Eigen::Matrix3d system; // origin + t direction = corner + a u + b v
        system << u, v, -ray.direction;
        if (ray.direction.dot(normal) >= 0) return infinity;
        const Vec3 abt = system.partialPivLu().solve(ray.origin - corner);
        const bool inside = abt.x() >= 0 && abt.x() <= 1 && abt.y() >= 0 && abt.y() <= 1 && abt.z() > 0;
        return inside ? abt.z() : infinity;
    }
};

/// Light that comes along `direction` from `distance` away, if nothing is in the way.
double arriving(const World &world, const Surface &surface, const Lobe &lobe, const Vec3 &direction, double distance,
                double irradiance) {
    if (direction.dot(surface.geometric) <= 0) return 0;
    const double light = irradiance * lobe(direction);
    if (light == 0 || world.all().closest({surface.position, direction, surface.triangle}, 0, distance)) return 0;
    return light;
}

} // namespace

double light_of_rects(const World &world, const Ray &ray, double t, Sees sees, int channel) {
    if (sees == Sees::not_asked) return 0;
    double sum = 0;
    for (const scene::Light &light : world.scene.lights)
        if (light.kind == LIGHT_RECT && (sees == Sees::all || light.visible) && Rect(world, light).meet(ray) < t)
            sum += light.radiance[channel];
    return sum;
}

double light_of_environments(const World &world, const Ray &ray, Sees sees, int channel) {
    double sum = 0;
    for (const scene::Light &light : world.scene.lights) {
        if (light.kind == LIGHT_ENVIRONMENT && (sees != Sees::camera || light.visible)) sum += light.radiance[channel];
    }
    if (sees == Sees::not_asked) return sum;
    for (const Sky &sky : world.skies)
        if (sees == Sees::all || sky.light().visible) sum += sky.radiance(ray.direction)[channel];
    return sum;
}

double light_of_surface(const World &world, const Surface &surface, const Vec3 &direction, int channel) {
    if (direction.dot(surface.geometric) >= 0) return 0;
    return world.value(surface, PARAMETER_emission_luminance) * world.value(surface, PARAMETER_emission_color, channel);
}

double direct_light(const World &world, const Surface &surface, const Lobe &lobe, bool wide, int channel,
                    Random &random) {
    double sum = 0;
    const auto ask = [&](const Vec3 &direction, double distance, double irradiance) {
        sum += arriving(world, surface, lobe, direction, distance, irradiance);
    };
    for (const scene::Light &light : world.scene.lights) {
        const double radiance = light.radiance[channel];
        if (light.kind == LIGHT_DIRECTIONAL) ask(-light.direction.normalized(), infinity, radiance);
        if (light.kind == LIGHT_POINT) {
            const Vec3 to = world.units.point(light.position) - surface.position;
            const double distance = to.norm(), in_scene = distance * world.units.size;
            ask(to / distance, distance, radiance / (in_scene * in_scene));
        }
        if (light.kind == LIGHT_RECT && wide) {
            const Rect rect(world, light);
            const double a = random(), b = random();
            const Vec3 to = rect.corner + a * rect.u + b * rect.v - surface.position;
            const double distance = to.norm(), cosine = -rect.normal.dot(to) / distance;
            if (cosine > 0) ask(to / distance, distance, radiance * cosine * rect.area / (distance * distance));
        }
    }
    for (const Sky &sky : world.skies) {
        if (!wide) continue;
        const auto [direction, density] = sky.draw(random);
        ask(direction, infinity, sky.radiance(direction)[channel] / density);
    }
    return sum;
}

} // namespace nacre::reference
