#include "oracle/reference_walk.h"
#include "oracle/reference_lobes.h"
#include <cmath>
#include <numbers>

namespace nacre::reference {
namespace {

/// In a scene of size 1 about its centre no body reaches as far out as `outside`, no way through it is as long as
/// `beyond`. A walk that does has slipped out through an edge, where Embree's float took another triangle than double:
/// its light is lost, less than 1e-6 of all.
constexpr double outside = 0.51, beyond = 2;

/// Where a flight of this length leaves the body. Shells inside are counted: in is +1, out is -1, at 0 it has left.
std::optional<Hit> boundary(const Rays &body, Ray ray, double length, int &shells) {
    double after = 0;
    while (const std::optional<Hit> hit = body.closest(ray, after, length)) {
        const Triangle &v = body[hit->triangle];
        shells += (v[1] - v[0]).cross(v[2] - v[0]).dot(ray.direction) < 0 ? 1 : -1;
        if (shells == 0) return hit;
        after = hit->t;
        ray.on = hit->triangle;
    }
    return {};
}

} // namespace

double flight(const Medium &medium, bool from_scatter, Random &random) {
    const double xi = random();
    if (medium.bleed == 0) return -std::log(xi) / medium.extinction;
    const double a = 1 / medium.bleed, power = medium.reciprocal && from_scatter ? a + 1 : a;
    return a * (std::pow(xi, -1 / power) - 1) / medium.extinction; // transmittance (1 + tau / a)^-power
}

Vec3 scattered(const Vec3 &direction, double g, Random &random) {
    const double xi = random();
    double cosine = 2 * xi - 1;
    if (g != 0) {
        const double root = (1 - g * g) / (1 - g + 2 * g * xi);
        cosine = std::clamp((1 + g * g - root * root) / (2 * g), -1.0, 1.0);
    }
    const double sine = std::sqrt(1 - cosine * cosine), azimuth = 2 * std::numbers::pi * random();
    return about(direction, {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine}).normalized();
}

std::optional<Hit> Walk::leave(const Rays &body, const Medium &medium, Random &random) {
    int shells = 1;
    for (bool from_scatter = false;; from_scatter = true) {
        const double length = flight(medium, from_scatter, random);
        if (const std::optional<Hit> hit = boundary(body, ray, length, shells)) return hit;
        ray.origin += std::min(length, beyond) * ray.direction;
        if (ray.origin.norm() > outside) return {};
        ray.on = no_triangle;
        ray.direction = scattered(ray.direction, medium.g, random);
        weight *= medium.albedo;
        if (++scatters == medium.max_depth || !survives(weight, random)) return {};
    }
}

} // namespace nacre::reference
