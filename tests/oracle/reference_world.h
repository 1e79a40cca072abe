#pragma once
#include "oracle/reference_rays.h"
#include "oracle/reference_sky.h"
#include "oracle/reference_walk.h"
#include "scene/normalise.h"
#include "scene/scene.h"

namespace nacre::reference {

/// Where a ray met something.
struct Surface {
    Vec3 position, geometric, shading; // unit normals, on the triangle's counter-clockwise side
    Vec2 uv{0, 0};
    std::uint32_t object = 0, triangle = no_triangle; // triangle: of all
};

/// A scene in lengths of its own size, about its centre, and what rays find in it.
class World {
  public:
    explicit World(const scene::Scene &scene);

    const scene::Scene &scene;
    const scene::Frame units;
    const std::vector<Sky> skies; // environments that are images

    const Rays &all() const { return rays; }

    /// An object's own triangles, counted from 0. Only of objects with a medium.
    const Rays &body(std::uint32_t object) const { return *bodies[object]; }
    std::uint32_t first_triangle(std::uint32_t object) const { return first[object]; }

    Surface surface(const Hit &hit) const;

    const scene::Material &material(const Surface &surface) const {
        return scene.materials[scene.objects[surface.object].material];
    }

    /// A material's parameter where the surface is met, one channel of it.
    double value(const Surface &surface, shared::Parameter parameter, int channel = 0) const;

    Medium medium(const Surface &surface, int channel) const;

  private:
    Rays rays;
    std::vector<std::unique_ptr<Rays>> bodies;
    std::vector<std::uint32_t> first;
};

} // namespace nacre::reference
