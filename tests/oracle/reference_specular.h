#pragma once
#include "base/vector.h"
#include "oracle/reference_random.h"

namespace nacre::reference {

/// Unpolarised reflectance of a smooth dielectric from outside, by the angles of Snell's law; eta >= 1.
double fresnel(double cosine, double eta);

/// From inside; `cosine` is inside. `eta` bends the light, `reflecting` is the index that reflects it.
double fresnel_inside(double cosine, double eta, double reflecting);

/// OpenPBR 1.1: the index whose reflectance at normal incidence is `weight` times that of `ior`.
double weighted_ior(double ior, double weight);

/// GGX microfacets with Smith's height-correlated shadowing (Heitz 2014), seen from `view`, both about +z.
struct Facets {
    double alpha;
    Vec3 view;

    /// The normal of a facet, in proportion to the area that the viewer sees of it.
    Vec3 draw(Random &random) const;

    /// Share of the facets that `light` sees too.
    double seen_by_both(const Vec3 &light) const;

    /// BSDF x cosine of mirrors, reflectance 1.
    double value(const Vec3 &light) const;
};

/// The reflecting layer of a surface for one channel: a dielectric, a metal, or a mixture.
struct Coat {
    double eta = 1, metalness = 0, metal = 0; // metal: its reflectance at normal incidence
    double alpha = 1;
    Vec3 normal, geometric, view; // view: towards the viewer, world

    Facets facets() const;
    double dielectric(double cosine) const { return fresnel(cosine, eta); }
    double reflectance(double cosine) const;

    /// BSDF x cosine towards `light`.
    double value(const Vec3 &light) const;
};

/// The shading normal turned so far towards the viewer that he sees it by .001.
Vec3 seen_normal(const Vec3 &shading, const Vec3 &view);

/// The way into a medium through a facet of normal h, Snell's law; `view` points outwards.
Vec3 refracted(const Vec3 &view, const Vec3 &h, double eta);

} // namespace nacre::reference
