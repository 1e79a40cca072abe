#pragma once
#include "oracle/reference_random.h"
#include "oracle/reference_world.h"
#include <functional>

namespace nacre::reference {

/// Which lights a ray may find by meeting them. Each is found in one way only: what a lobe asks lights for, its ray
/// must not see again.
enum class Sees {
    camera,    // what is visible
    all,       // reflections in the coat: light from a random point of a rect would be in its lobe too seldom
    not_asked, // after a diffuse lobe, which asks rects and images of environments
};

/// One channel of what a ray from `ray.origin` finds of rects on its way up to t, and of environments if there is no
/// end.
double light_of_rects(const World &world, const Ray &ray, double t, Sees sees, int channel);
double light_of_environments(const World &world, const Ray &ray, Sees sees, int channel);

/// Emission of a surface towards its counter-clockwise side.
double light_of_surface(const World &world, const Surface &surface, const Vec3 &direction, int channel);

/// BSDF x cosine of a lobe towards a direction.
using Lobe = std::function<double(const Vec3 &direction)>;

/// What a surface, whose geometric normal is on the lit side, gets through a lobe from all point and directional
/// lights, and with `wide` from a random point of each rect and each image of an environment, where nothing is in the
/// way.
double direct_light(const World &world, const Surface &surface, const Lobe &lobe, bool wide, int channel,
                    Random &random);

} // namespace nacre::reference
