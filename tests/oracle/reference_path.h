#pragma once
#include "oracle/reference_lights.h"
#include "oracle/reference_specular.h"

namespace nacre::reference {

/// One channel of one path from the camera.
class Path {
  public:
    Path(const World &world, int channel, Random &random) : world(world), channel(channel), random(random) {}

    /// The light that `ray` brings.
    double trace(const Ray &ray);

  private:
    void scatter(const Surface &surface, const Vec3 &view);
    bool reflect(const Surface &surface, const Coat &coat, Vec3 &facet);
    void diffuse(const Surface &surface, double albedo);
    void below(const Surface &surface, const Vec3 &inwards);
    Vec3 entry(const Surface &surface, const Vec3 &view, const Vec3 *facet);
    bool turned_back(const Surface &surface, const Vec3 &direction);
    void go(const Surface &surface, const Vec3 &direction, Sees what);

    const World &world;
    const int channel;
    Random &random;
    double light = 0, throughput = 1;
    Ray ray;
    Sees sees = Sees::camera;
    bool ends = false;
};

} // namespace nacre::reference
