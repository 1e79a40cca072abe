#pragma once
#include "oracle/reference_random.h"
#include "oracle/reference_rays.h"

namespace nacre::reference {

/// What one channel of light meets below a surface.
struct Medium {
    double extinction = 1, albedo = 0, g = 0, bleed = 0;
    bool reciprocal = false;     // flights from scatters by the law of that model
    std::uint32_t max_depth = 0; // scatters a walk may have, 0: no cap
};

/// Length of a flight: exponential without bleed, else Davis & Xu 2014 with a = 1 / bleed, of which the reciprocal
/// model (d'Eon 2018) takes another member from scatters. Infinite where double cannot hold it.
double flight(const Medium &medium, bool from_scatter, Random &random);

/// Direction after a scatter, Henyey & Greenstein 1941.
Vec3 scattered(const Vec3 &direction, double g, Random &random);

/// A path below a surface.
struct Walk {
    Ray ray;                    // its flight; begins at the surface, inwards
    double weight = 1;          // what absorption has left
    std::uint32_t scatters = 0; // in all

    /// From the surface to where it leaves `body`. Nothing where it ends inside: absorbed, or over its cap.
    std::optional<Hit> leave(const Rays &body, const Medium &medium, Random &random);
};

} // namespace nacre::reference
