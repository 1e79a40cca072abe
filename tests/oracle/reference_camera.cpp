#include "oracle/reference_camera.h"
#include <cmath>
#include <numbers>

namespace nacre::reference {

using std::numbers::pi;

Ray camera_ray(const World &world, int x, int y, Random &random) {
    const scene::Camera &camera = world.scene.camera;
    const scene::ImageSettings &image = world.scene.image;
    const Vec3 forward = (camera.target - camera.position).normalized();
    const Vec3 right = forward.cross(camera.up).normalized(), up = right.cross(forward);
    const double column = (x + random()) / image.width - 0.5, row = 0.5 - (y + random()) / image.height;
    const double aspect = double(image.width) / image.height;
    if (camera.kind == shared::CAMERA_ORTHOGRAPHIC) {
        const Vec3 start = camera.position + camera.height * (column * aspect * right + row * up);
        return {world.units.point(start), forward};
    }
    const double height = 2 * std::tan(camera.fov / 2 * pi / 180); // of the picture at distance 1
    const Vec3 to = forward + height * (column * aspect * right + row * up);
    const double focus = camera.focus_distance > 0 ? camera.focus_distance : (camera.target - camera.position).norm();
    const double radius = camera.aperture / 2 * std::sqrt(random()), azimuth = 2 * pi * random();
    const Vec3 start = camera.position + radius * (std::cos(azimuth) * right + std::sin(azimuth) * up);
    const Vec3 sharp = camera.position + focus * to; // where all rays of this point of the picture meet
    return {world.units.point(start), (sharp - start).normalized()};
}

} // namespace nacre::reference
