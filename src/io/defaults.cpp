#include "io/defaults.h"

namespace nacre::io {

namespace {

Json to_json(const Vec3 &v) { return {v.x(), v.y(), v.z()}; }

// A square light that faces the centre of `box` from `direction`, 1.5 diagonals away: outside of the box.
Json square_light(const scene::Bounds &box, const Vec3 &direction, double radiance) {
    const double diagonal = box.diagonal().norm();
    const Vec3 away = direction.normalized();
    const Vec3 u = Vec3::UnitY().cross(away).normalized(), v = u.cross(away); // u x v = -away: emits inwards
    return {{"type", "rect"},
            {"center", to_json(box.center() + 1.5 * diagonal * away)},
            {"u", to_json(0.8 * diagonal * u)},
            {"v", to_json(0.8 * diagonal * v)},
            {"radiance", radiance}};
}

} // namespace

Json default_skin(const scene::Bounds &box) {
    return {{"subsurface_weight", 1},
            {"subsurface_color", {0.8, 0.5, 0.4}},
            {"subsurface_radius", 0.02 * box.diagonal().norm()},
            {"subsurface_radius_scale", {1, 0.35, 0.2}},
            {"specular_roughness", 0.4},
            {"specular_ior", 1.4}};
}

// A square of .8 diagonals at 1.5 gives the surface facing it an irradiance of about .28 times its radiance. With 7
// for the key a white surface facing it gets a radiance of .6, and .4 more from around.
Json default_lights(const scene::Bounds &box) {
    return Json::array({{{"type", "environment"}, {"radiance", 0.4}},
                        square_light(box, Vec3(-1, 1.2, 1.2), 7),
                        square_light(box, Vec3(0.8, 0.5, -1.2), 12)});
}

} // namespace nacre::io
