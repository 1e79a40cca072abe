#include "scene/bounds.h"

namespace nacre::scene {

Bounds bounds(const Mesh &mesh) {
    Bounds box;
    for (const auto &triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle) box.extend(mesh.positions[vertex]);
    return box;
}

Bounds bounds(const std::vector<Object> &objects) {
    Bounds box;
    for (const Object &object : objects) box.extend(bounds(object.mesh));
    return box;
}

} // namespace nacre::scene
