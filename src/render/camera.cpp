#include "render/camera.h"
#include "render/convert.h"
#include <cmath>
#include <numbers>

namespace nacre::render {

shared::Camera to_device(const scene::Camera &source, const scene::ImageSettings &image, const scene::Frame &frame) {
    const Vec3 to_target = source.target - source.position;
    const Vec3 forward = to_target.normalized();
    Vec3 right = forward.cross(source.up);
    if (right.norm() < 1e-9 * source.up.norm()) right = forward.cross(Vec3::Unit(std::abs(forward.x()) < 0.9 ? 0 : 2));
    right.normalize();

    shared::Camera camera{};
    camera.position = to_float4(frame.point(source.position));
    camera.right = to_float4(right);
    camera.up = to_float4(right.cross(forward));
    camera.forward = to_float4(forward);
    camera.kind = source.kind;
    const bool perspective = source.kind == shared::CAMERA_PERSPECTIVE;
    const double half_height =
        perspective ? std::tan(0.5 * source.fov * std::numbers::pi / 180) : 0.5 * source.height / frame.size;
    camera.half_height = float(half_height);
    camera.half_width = float(half_height * image.width / image.height);
    camera.lens_radius = perspective ? float(0.5 * source.aperture / frame.size) : 0;
    const double focus = source.focus_distance > 0 ? source.focus_distance : to_target.norm();
    camera.focus_distance = float(focus / frame.size);
    return camera;
}

} // namespace nacre::render
