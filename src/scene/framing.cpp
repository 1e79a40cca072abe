#include "scene/framing.h"
#include <algorithm>
#include <numbers>

namespace nacre::scene {

namespace {

constexpr double margin = 1.1;     // of the picture to the box
constexpr double elevation = 0.25; // the camera's height above the centre, per distance in front of it

} // namespace

void frame(Camera &camera, const Bounds &box, double aspect) {
    const Vec3 back = Vec3(0, elevation, 1).normalized(); // towards the camera
    const Vec3 right = Vec3::UnitX(), up = back.cross(right);
    const double tan_y = std::tan(camera.fov / 2 * std::numbers::pi / 180), tan_x = tan_y * aspect;
    double distance = 0, height = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 offset = box.corner(static_cast<Bounds::CornerType>(corner)) - box.center();
        const double x = std::abs(offset.dot(right)) * margin, y = std::abs(offset.dot(up)) * margin;
        distance = std::max(distance, offset.dot(back) + std::max(x / tan_x, y / tan_y));
        height = std::max(height, 2 * std::max(y, x / aspect));
    }
    // An orthographic camera only has to be outside; so has one with a very wide fov.
    distance = std::max(distance, box.diagonal().norm());
    camera.target = box.center();
    camera.position = camera.target + distance * back;
    camera.up = Vec3::UnitY();
    camera.height = height;
}

} // namespace nacre::scene
