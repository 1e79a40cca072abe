#include "scene/normalise.h"
#include "scene/bounds.h"

namespace nacre::scene {

Frame frame_of(const Scene &scene) {
    const Bounds box = bounds(scene.objects);
    Frame frame;
    if (box.isEmpty()) return frame;
    frame.centre = box.center();
    const double diagonal = box.diagonal().norm();
    if (diagonal > 0) frame.size = diagonal;
    return frame;
}

} // namespace nacre::scene
