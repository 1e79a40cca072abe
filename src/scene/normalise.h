#pragma once
#include "scene/scene.h"

namespace nacre::scene {

/// The frame in which kernels see a scene: p -> (p - centre) / size. Computed and applied in double, so that neither
/// the place nor the scale of a scene costs digits.
struct Frame {
    Vec3 centre{0, 0, 0}; // of the objects' bounding box
    double size = 1;      // its diagonal

    Vec3 point(const Vec3 &p) const { return (p - centre) / size; }
    Vec3 vector(const Vec3 &v) const { return v / size; }
};

/// The frame of a scene; it has at least one object with extent.
Frame frame_of(const Scene &scene);

} // namespace nacre::scene
