#pragma once
#include "image/rendered.h"

namespace nacre {

/// A diffuse floor (y = 0, 2 x 2 units) of albedo `rho`, seen from the side by
/// an orthographic camera whose 8 x 8 pixels are one point: the origin. Without lights.
scene::Scene floor_scene(double rho = 1);

scene::Light rect_light(const Vec3 &center, const Vec3 &u, const Vec3 &v, const Vec3 &radiance);
scene::Light point_light(const Vec3 &position, const Vec3 &intensity);
scene::Light directional_light(const Vec3 &direction, const Vec3 &irradiance);
scene::Light constant_sky(const Vec3 &radiance);

/// An environment image whose texels are `radiance`(direction to the texel's centre).
scene::Light image_sky(std::uint32_t width, std::uint32_t height, Vec3 radiance(const Vec3 &));

/// A flat or closed mesh that emits `radiance`.
void add_emitter(scene::Scene &scene, scene::Mesh mesh, const Vec3 &radiance);

/// A quad of the corner `a` and the edges `u` and `v`, its front towards u x v, uvs 0..1 along the edges.
scene::Mesh quad(const Vec3 &a, const Vec3 &u, const Vec3 &v);

/// RGB, its standard error, and alpha.
struct Shot {
    Vec3 mean{0, 0, 0}, error{0, 0, 0};
    double alpha = 0;
};

/// Renders a scene whose pixels all show the same, which are independent of each other: their mean, its error from
/// their spread.
Shot shoot(scene::Scene scene, std::uint32_t spp);

/// Renders a scene; its pixels, row by row, without errors.
std::vector<Shot> shoot_all(scene::Scene scene, std::uint32_t spp);

/// Expects a shot within 4 standard errors (and `slack`, for what the test's own value leaves out) of `exact`, and the
/// errors at most `largest_error` of it.
void expect_shot(const Shot &shot, const Vec3 &exact, double largest_error, double slack, const std::string &what);

/// Expects two shots to be of the same radiance, by their errors.
void expect_same(const Shot &a, const Shot &b, double largest_error, const std::string &what);

/// Irradiance of a uniform rect with edges `a`, `b` at `height` above the middle of a parallel patch, per radiance: the
/// form factor of a differential patch against a parallel rect (Howell, "A Catalog of Radiation Heat Transfer
/// Configuration Factors", B-3), four times, times pi.
double rect_irradiance(double a, double b, double height);

} // namespace nacre
