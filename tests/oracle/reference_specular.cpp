#include "oracle/reference_specular.h"
#include "oracle/reference_lobes.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace nacre::reference {
namespace {

using std::numbers::pi;

/// Smith's Lambda, from the tangent of the angle to the normal.
double lambda(const Vec3 &v, double alpha) {
    const double tangent = std::hypot(v.x(), v.y()) / std::abs(v.z());
    return (std::sqrt(1 + alpha * alpha * tangent * tangent) - 1) / 2;
}

} // namespace

double fresnel(double cosine, double eta) {
    if (eta == 1) return 0;
    const double outside = std::acos(std::clamp(cosine, 0.0, 1.0));
    if (outside < 1e-4) return std::pow((eta - 1) / (eta + 1), 2); // the formulas below are 0 / 0 at 0
    const double inside = std::asin(std::sin(outside) / eta);
    const double s = std::sin(outside - inside) / std::sin(outside + inside);
    const double p = std::tan(outside - inside) / std::tan(outside + inside);
    return (s * s + p * p) / 2;
}

double fresnel_inside(double cosine, double eta, double reflecting) {
    const double sine = eta * std::sqrt(std::max(0.0, 1 - cosine * cosine));
    return sine < 1 ? fresnel(std::sqrt(1 - sine * sine), reflecting) : 1;
}

double weighted_ior(double ior, double weight) {
    const double root = std::sqrt(std::min(weight, 1.0) * fresnel(1, ior));
    return (1 + root) / (1 - root);
}

// Dupuy & Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps" (the kernels take Heitz 2018).
Vec3 Facets::draw(Random &random) const {
    const Vec3 v = Vec3(alpha * view.x(), alpha * view.y(), view.z()).normalized();
    const double azimuth = 2 * pi * random(), z = (1 - random()) * (1 + v.z()) - v.z();
    const double sine = std::sqrt(std::max(0.0, 1 - z * z));
    const Vec3 h = v + Vec3(sine * std::cos(azimuth), sine * std::sin(azimuth), z);
    return Vec3(alpha * h.x(), alpha * h.y(), h.z()).normalized();
}

double Facets::seen_by_both(const Vec3 &light) const {
    const double mine = lambda(view, alpha);
    return (1 + mine) / (1 + mine + lambda(light, alpha));
}

double Facets::value(const Vec3 &light) const {
    const Vec3 h = (light + view).normalized();
    const double stretched = (h.x() * h.x() + h.y() * h.y()) / (alpha * alpha) + h.z() * h.z();
    const double distribution = 1 / (pi * alpha * alpha * stretched * stretched);
    return distribution / (1 + lambda(view, alpha) + lambda(light, alpha)) / (4 * view.z());
}

Facets Coat::facets() const { return {alpha, seen_from(normal, view)}; }

double Coat::reflectance(double cosine) const {
    const double schlick = metal + (1 - metal) * std::pow(1 - cosine, 5);
    return (1 - metalness) * dielectric(cosine) + metalness * schlick;
}

double Coat::value(const Vec3 &light) const {
    if (light.dot(geometric) <= 0) return 0;
    double sum = 0;
    for (const Vec3 &world : {light, mirrored(light, geometric)}) { // the lobe is folded
        const Facets seen = facets();
        const Vec3 local = seen_from(normal, world);
        if (local.z() <= 0) continue;
        sum += reflectance(local.dot((local + seen.view).normalized())) * seen.value(local);
    }
    return sum;
}

Vec3 seen_normal(const Vec3 &shading, const Vec3 &view) {
    const double seen = shading.dot(view);
    return seen >= 1e-3 ? shading : (shading + (1e-3 - seen) * view).normalized();
}

Vec3 refracted(const Vec3 &view, const Vec3 &h, double eta) {
    const double cosine = std::clamp(view.dot(h), 0.0, 1.0);
    const Vec3 across = view - cosine * h; // of length sin
    const double sine2 = across.squaredNorm() / (eta * eta);
    return (-across / eta - std::sqrt(std::max(0.0, 1 - sine2)) * h).normalized();
}

} // namespace nacre::reference
