#include "io/object.h"
#include "base/error.h"
#include "io/mesh_file.h"
#include <algorithm>

namespace nacre::io {

scene::Object make_object(const std::string &name, scene::Mesh mesh, const Transform &transform,
                          std::optional<bool> smooth, const std::string &subject, std::vector<std::string> &warnings) {
    check_mesh(mesh, subject);
    scene::Object object{name, std::move(mesh), 0, 0};
    scene::apply(object.mesh, transform);
    check_mesh(object.mesh, subject);
    object.degenerate = scene::drop_degenerate(object.mesh);
    if (object.mesh.triangles.empty()) input_error(subject, "none of its {} triangles has an area", object.degenerate);

    std::vector<Vec3f> &normals = object.mesh.normals;
    if (smooth == false) normals.clear();
    const bool usable = std::all_of(normals.begin(), normals.end(), [](const Vec3f &n) {
        return n.allFinite() && n.squaredNorm() > 0.5f; // apply() made them unit, or left them zero
    });
    if (!usable) warnings.push_back(subject + ": some normals are zero or not finite, all are computed instead");
    if (!usable || (smooth == true && normals.empty())) scene::compute_normals(object.mesh);
    return object;
}

} // namespace nacre::io
