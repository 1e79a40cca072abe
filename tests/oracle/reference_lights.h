#pragma once
#include "oracle/reference_random.h"
#include "oracle/reference_world.h"
#include <functional>

namespace nacre::reference {

/// Which lights a ray may find by meeting them. Each is found in one way only: what a lobe asks lights for, its ray
/// must not see again.
enum class Sees {
    camera,   // what is visible
    all,      // rects too: reflections in the coat, which light from a point of a rect would meet too seldom
    no_rects, // after a diffuse lobe, which has asked the rects
};

/// One channel of what a ray from `ray.origin` finds of rects on its way up to t, and of environments if there is no
/// end.
double light_of_rects(const World &world, const Ray &ray, double t, Sees sees, int channel);
double light_of_environments(const World &world, const Ray &ray, Sees sees, int channel);

/// Emission of a surface towards its counter-clockwise side.
double light_of_surface(const World &world, const Surface &surface, const Vec3 &direction, int channel);

/// BSDF x cosine of a lobe towards a direction.
using Lobe = std::function<double(const Vec3 &direction)>;

/// What a surface gets through a lobe from all point and directional lights, and with `rects` from one random point on
/// each rect, where nothing is in the way. `side`: unit, the geometric normal on the side that is lit.
double direct_light(const World &world, const Surface &surface, const Vec3 &side, const Lobe &lobe, bool rects,
                    int channel, Random &random);

} // namespace nacre::reference
