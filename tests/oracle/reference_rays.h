#pragma once
#include "base/vector.h"
#include <array>
#include <cstdint>
#include <embree3/rtcore.h>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace nacre::reference {

using Triangle = std::array<Vec3, 3>; // counter-clockwise seen from outside, in a scene of about unit size

constexpr std::uint32_t no_triangle = 0xffffffffu;

/// A ray, and the triangle it starts on, which it cannot meet.
struct Ray {
    Vec3 origin, direction; // direction: unit
    std::uint32_t on = no_triangle;
};

struct Hit {
    double t = 0;
    std::uint32_t triangle = no_triangle;
    Vec3 weights{0, 0, 0}; // of the triangle's vertices
};

/// Triangles and Embree's tree over them.
class Rays {
  public:
    explicit Rays(std::vector<Triangle> triangles);

    /// The first triangle with after < t < before. Any thread.
    std::optional<Hit> closest(const Ray &ray, double after = 0,
                               double before = std::numeric_limits<double>::infinity()) const;

    const Triangle &operator[](std::uint32_t triangle) const { return triangles[triangle]; }

  private:
    struct Release {
        void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
        void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    };
    std::vector<Triangle> triangles;
    std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release> device;
    std::unique_ptr<std::remove_pointer_t<RTCScene>, Release> scene;
};

} // namespace nacre::reference
