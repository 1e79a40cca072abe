#pragma once
#include "scene/scene.h"

namespace nacre::test {

/// A light that was drawn; see kernels/probe_light.cl. Lengths and radiance are in the scene's units.
struct LightDraw {
    Vec3 direction{0, 0, 0};
    double distance = 0;    // 0: nothing was drawn
    Vec3 radiance{0, 0, 0}; // over the density; a point's or direction's: irradiance over its chance
    double density = 0;
    Vec2 texel{0, 0}; // image environments
    double density_again = 0;
    Vec3 radiance_again{0, 0, 0};
};

/// `count` draws from the lights of `scene`, seen from `position` on a surface with the unit normal `normal`.
std::vector<LightDraw> draw_lights(const scene::Scene &scene, const Vec3 &position, const Vec3 &normal,
                                   std::uint32_t count, std::uint32_t seed);

/// A scene of one box, so that there is something to be lit.
scene::Scene scene_with_box();

} // namespace nacre::test
