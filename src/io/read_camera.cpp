#include "io/read_scene.h"
#include "scene/framing.h"

namespace nacre::io {

namespace {

constexpr Choice kinds[] = {{"perspective", shared::CAMERA_PERSPECTIVE}, {"orthographic", shared::CAMERA_ORTHOGRAPHIC}};

} // namespace

void read_camera(const Json *tree, Reading &reading) {
    const Json empty = Json::object();
    Fields fields(tree ? *tree : empty, "camera", "camera", reading.source);
    scene::Camera &camera = reading.scene.camera;
    fields.read_choice("type", kinds, camera.kind);
    fields.read("fov", camera.fov);
    fields.read("aperture", camera.aperture);
    fields.read("focus_distance", camera.focus_distance);

    const scene::ImageSettings &image = reading.scene.image;
    frame(camera, scene::bounds(reading.scene.objects), static_cast<double>(image.width) / image.height);
    const Vec3 framed = camera.position - camera.target;
    fields.read("height", camera.height);
    fields.read("target", camera.target);
    camera.position = camera.target + framed;
    fields.read("position", camera.position);
    fields.read("up", camera.up);
    fields.finish();

    const Vec3 forward = camera.target - camera.position;
    if (!(forward.norm() > 0)) fields.fail("target", "is where the camera is, so it looks nowhere");
    // A millionth of a radian is as far as floats can tell the two directions apart.
    if (!(forward.stableNormalized().cross(camera.up.stableNormalized()).norm() > 1e-6))
        fields.fail("up", "is along the direction of view (or zero), choose another");
}

} // namespace nacre::io
