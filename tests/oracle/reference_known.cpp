#include "oracle/reference_known.h"
#include "base/error.h"
#include "scene/closed.h"

namespace nacre::reference {

using namespace shared;

void expect_known(const scene::Scene &scene) {
    const auto refuse = [&](const std::string &what) {
        throw Error(Exit::input, scene.file, "the reference renderer knows no " + what);
    };
    for (const scene::Object &object : scene.objects) {
        const scene::Material &material = scene.materials[object.material];
        if (material[PARAMETER_geometry_normal].texture >= 0 && object.mesh.uvs.empty())
            refuse("normal map on " + object.name + ", which has no uvs");
        if (!scene::scatters_below(material)) continue;
        if (material.model != MODEL_RANDOM_WALK)
            refuse("subsurface_model but random_walk, for '" + material.name + "'");
        if (material.inversion != INVERSION_NONE)
            refuse("inversion: give subsurface_albedo for '" + material.name + "'");
        if (!scene::is_closed(object.mesh)) refuse("open meshes with a medium, as " + object.name);
    }
}

} // namespace nacre::reference
