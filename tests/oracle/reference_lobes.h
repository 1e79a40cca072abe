#pragma once
#include "base/vector.h"
#include "oracle/reference_random.h"

namespace nacre::reference {

/// `local`, given about +z, about the unit vector `normal`.
Vec3 about(const Vec3 &normal, const Vec3 &local);

/// Coordinates of `world` about `normal`, the inverse of `about`.
Vec3 seen_from(const Vec3 &normal, const Vec3 &world);

/// Mirrored at the plane of `geometric`.
Vec3 mirrored(const Vec3 &direction, const Vec3 &geometric);

/// The same if it is below, as lobes about a shading normal have it: what would go into the surface is turned out of
/// it.
Vec3 folded(const Vec3 &direction, const Vec3 &geometric);

/// Directions about +z with density cos / pi, and 1 / (2 pi).
Vec3 cosine_direction(Random &random);
Vec3 uniform_direction(Random &random);

/// Lambert's lobe about `shading`, folded; and BSDF x cosine of it, of albedo 1.
Vec3 lambert_direction(const Vec3 &shading, const Vec3 &geometric, Random &random);
double lambert_value(const Vec3 &direction, const Vec3 &shading, const Vec3 &geometric);

} // namespace nacre::reference
