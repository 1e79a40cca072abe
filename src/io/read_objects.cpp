#include "io/defaults.h"
#include "io/extension.h"
#include "io/find_file.h"
#include "io/gltf.h"
#include "io/mesh_file.h"
#include "io/nearest.h"
#include "io/object.h"
#include "io/read_material.h"
#include "io/read_scene.h"
#include <algorithm>
#include <fmt/format.h>
#include <numbers>

namespace nacre::io {

namespace {

Transform read_transform(const Json &tree, const std::string &path, const Source &source) {
    Fields fields(tree, path, "transform", source);
    Vec3 scale = Vec3::Ones(), degrees = Vec3::Zero(), translate = Vec3::Zero();
    fields.read_color("scale", scale);
    fields.read("rotate", degrees);
    fields.read("translate", translate);
    fields.finish();
    const Vec3 angle = degrees * (std::numbers::pi / 180);
    return Eigen::Translation3d(translate) * Eigen::AngleAxisd(angle.z(), Vec3::UnitZ()) *
           Eigen::AngleAxisd(angle.y(), Vec3::UnitY()) * Eigen::AngleAxisd(angle.x(), Vec3::UnitX()) *
           Eigen::Scaling(scale);
}

scene::Mesh read_sphere(const Json &tree, const std::string &path, const Source &source) {
    Fields fields(tree, path, "sphere", source);
    Vec3 center = Vec3::Zero();
    double radius = 1;
    int segments = 256;
    fields.read("center", center);
    fields.read("radius", radius);
    fields.read("segments", segments);
    fields.finish();
    return scene::make_sphere(center, radius, segments);
}

scene::Mesh read_box(const Json &tree, const std::string &path, const Source &source) {
    Fields fields(tree, path, "box", source);
    Vec3 lower = -Vec3::Ones(), upper = Vec3::Ones();
    fields.read("min", lower);
    fields.read("max", upper);
    fields.finish();
    if (!((upper - lower).minCoeff() > 0)) fields.fail("max", "must be greater than min in x, y and z");
    return scene::make_box(lower, upper);
}

// One entry of "objects" as far as it is the same for every kind of shape.
class ObjectReader {
  public:
    ObjectReader(const Json &tree, const std::string &path, Reading &reading)
        : fields(tree, path, "object", reading.source), path(path), reading(reading) {}

    void read() {
        if (const Json *tree = fields.find("transform"))
            transform = read_transform(*tree, fields.path("transform"), reading.source);
        if (fields.find("smooth")) fields.read("smooth", smooth.emplace());
        const Json *sphere = fields.find("sphere"), *box = fields.find("box"), *mesh = fields.find("mesh");
        find_material();
        fields.finish();
        if (!!sphere + !!box + !!mesh != 1) reading.source.fail(path, "needs exactly one of mesh, sphere, box");
        const std::string subject = reading.source.file.string() + ": " + path;
        if (sphere) {
            add("sphere", read_sphere(*sphere, fields.path("sphere"), reading.source), subject);
        } else if (box) {
            add("box", read_box(*box, fields.path("box"), reading.source), subject);
        } else {
            read_mesh();
        }
    }

  private:
    void find_material() {
        std::string name;
        fields.read("material", name);
        if (!fields.find("material")) return;
        std::vector<std::string> names;
        for (const scene::Material &candidate : reading.scene.materials) names.push_back(candidate.name);
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end())
            fields.fail("material", fmt::format("there is no material '{}'{}", name, suggest(name, names)));
        material = static_cast<std::uint32_t>(found - names.begin());
    }

    void read_mesh() {
        std::string name;
        fields.read("mesh", name);
        const std::filesystem::path file = find_file(reading.source, fields.path("mesh"), name);
        const std::string extension = extension_of(file);
        std::vector<std::string> &warnings = reading.scene.warnings;
        if (extension == ".obj")
            add(name, load_obj(file, warnings), file.string());
        else if (extension == ".ply")
            add(name, load_ply(file), file.string());
        else if (extension != ".gltf" && extension != ".glb")
            fields.fail("mesh", fmt::format("'{}' is not a mesh nacre reads: .obj .ply .gltf .glb", name));
        else if (material)
            add(name, load_gltf_mesh(file, warnings), file.string());
        else
            add_gltf_objects(file, fmt::format("{} ({})", path, name), transform, smooth, reading.scene, reading.maps);
    }

    void add(const std::string &name, scene::Mesh mesh, const std::string &subject) {
        scene::Object object = make_object(fmt::format("{} ({})", path, name), std::move(mesh), transform, smooth,
                                           subject, reading.scene.warnings);
        object.material = material ? *material : default_material(object);
        reading.scene.objects.push_back(std::move(object));
    }

    // Its mean free path follows the object's size, so each such object has its own.
    std::uint32_t default_material(const scene::Object &object) {
        scene::Material skin;
        skin.name = fmt::format("default of {}", path);
        read_material(default_skin(scene::bounds(object.mesh)), skin.name, reading.source, reading.maps, skin);
        reading.scene.materials.push_back(skin);
        return static_cast<std::uint32_t>(reading.scene.materials.size()) - 1;
    }

    Fields fields;
    const std::string path;
    Reading &reading;
    Transform transform = Transform::Identity();
    std::optional<bool> smooth;
    std::optional<std::uint32_t> material;
};

} // namespace

void read_objects(const Json *tree, Reading &reading) {
    if (!tree) reading.source.fail("objects", "is missing: a scene needs at least one object");
    if (!tree->is_array() || tree->empty())
        reading.source.fail("objects", fmt::format("expected an array of objects, got {}", describe(*tree)));
    for (std::size_t i = 0; i < tree->size(); ++i)
        ObjectReader((*tree)[i], fmt::format("objects.{}", i), reading).read();
}

} // namespace nacre::io
