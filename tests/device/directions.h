#pragma once
#include "base/vector.h"
#include "device/probe.h"
#include <numbers>

namespace nacre::test {

/// Axes of float length 1, as exactly as float has them; -z is where the basis of frame.h changes sign.
inline std::vector<Vec3f> axes() {
    return {{0, 0, 1}, {0, 0, -1}, Vec3f(1, -2, 3).normalized(), Vec3f(-3, 1, -1e-4f).normalized()};
}

/// Azimuth of `direction` about `axis`, in turns, in a frame of the test's own.
inline double azimuth(const Vec3 &direction, const Vec3 &axis) {
    const Vec3 side = axis.cross(std::abs(axis.x()) < .7 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)).normalized();
    const double turns = std::atan2(direction.dot(axis.cross(side)), direction.dot(side)) / (2 * std::numbers::pi);
    return turns < 0 ? turns + 1 : turns;
}

/// The first three of four floats of item i.
inline Vec3 direction_of(const std::vector<float> &values, std::size_t i) {
    return {values[4 * i], values[4 * i + 1], values[4 * i + 2]};
}

inline void set_axis(Probe &probe, const Vec3f &axis) {
    probe.a = axis.x();
    probe.b = axis.y();
    probe.c = axis.z();
}

} // namespace nacre::test
