#pragma once
#include "accel/embree_scene.h"
#include <string>

namespace nacre::bench {

struct RaySet {
    std::string name;
    std::vector<ProbeRay> rays;
};

/// The rays that subsurface scattering asks for: random walks inside at mean free paths of .2, 1 and 10 % of the mesh's
/// size (t_max is the length of the step), camera rays, and diffuse bounces from where these hit. About `count` of
/// each.
std::vector<RaySet> make_ray_sets(std::span<const accel::Triangle> triangles, const EmbreeScene &scene,
                                  std::size_t count);

} // namespace nacre::bench
