#pragma once
#include "oracle/reference_random.h"
#include "scene/scene.h"
#include <utility>
#include <vector>

namespace nacre::reference {

/// An environment image: latitude-longitude, column u = 1/2 + atan2(z, x) / 2 pi, row 0 at +y, turned counter-clockwise
/// about +y by its `rotate`; bilinear, round the circle, held at the poles.
class Sky {
  public:
    explicit Sky(const scene::Light &light);

    const scene::Light &light() const { return *source; }

    Vec3 radiance(const Vec3 &direction) const;

    /// A direction, and its density per steradian, which is above 0 wherever there is light.
    std::pair<Vec3, double> draw(Random &random) const;

  private:
    Vec3 texel(std::int64_t x, std::int64_t y) const;
    double top_of(std::int64_t row) const; // y of a row's upper edge on the unit sphere

    const scene::Light *source;
    double turn;                    // radians
    std::vector<double> cumulative; // of the texels' weights
};

} // namespace nacre::reference
