#include "io/gltf.h"
#include "base/error.h"
#include "io/defaults.h"
#include "io/gltf_material.h"
#include "io/gltf_mesh.h"
#include "io/gltf_nodes.h"
#include "io/gltf_view.h"
#include "io/object.h"
#include "io/read_material.h"
#include "scene/merge.h"
#include <set>

namespace nacre::io {

namespace {

constexpr int no_material = -1;

struct Part {
    std::string name;
    int material;
    scene::Mesh mesh; // world space
};

std::vector<Part> read_parts(const GltfFile &file, std::vector<std::string> &warnings) {
    std::vector<Part> parts;
    for (const GltfNode &placed : place_nodes(file)) {
        const tinygltf::Node &node = file.model.nodes[placed.index];
        if (node.mesh == -1) continue;
        if (node.skin >= 0)
            warnings.push_back(fmt::format("{}: nodes.{}: its skin is not used", file.subject, placed.index));
        for (auto &[material, mesh] : read_gltf_mesh(file, node.mesh, warnings)) {
            if (mesh.triangles.empty()) continue;
            scene::apply(mesh, placed.to_world);
            parts.push_back(
                {node.name.empty() ? fmt::format("nodes.{}", placed.index) : node.name, material, std::move(mesh)});
        }
    }
    if (parts.empty()) input_error(file.subject, "has no triangles in its scene");
    return parts;
}

void warn_of_file(const GltfFile &file, std::vector<std::string> &warnings) {
    if (gltf_member(file.json, "animations")) warnings.push_back(file.subject + ": animations are not used");
    static const std::set<std::string> known{"KHR_lights_punctual", "KHR_texture_transform", "KHR_mesh_quantization"};
    const Json *used = gltf_member(file.json, "extensionsUsed");
    if (!used || !used->is_array()) return;
    for (const Json &name : *used) {
        const std::string text = name.is_string() ? name.get<std::string>() : "";
        if (!known.count(text) && !text.starts_with("KHR_materials_")) // materials say so themselves
            warnings.push_back(fmt::format("{}: the extension {} is not used", file.subject, text));
    }
}

// The materials of a file as those of the scene, each read when the first object asks for it.
class Materials {
  public:
    Materials(const GltfFile &file, const std::string &prefix, const scene::Bounds &box, scene::Scene &scene,
              Maps &maps)
        : file(file), prefix(prefix), box(box), scene(scene), maps(maps) {}

    std::uint32_t get(int index) {
        const auto [entry, is_new] = known.try_emplace(index, static_cast<std::uint32_t>(scene.materials.size()));
        if (is_new) scene.materials.push_back(read(index));
        return entry->second;
    }

  private:
    scene::Material read(int index) {
        scene::Material material;
        if (index == no_material)
            read_material(default_skin(box), "default", Source{file.path, {}}, maps, material);
        else
            material = read_gltf_material(file, index, 0.02 * box.diagonal().norm(), maps, scene.warnings);
        material.name = prefix + name_of(index);
        return material;
    }

    std::string name_of(int index) {
        std::string name = "default";
        if (index != no_material) {
            const Json *given = gltf_member(gltf_element(file, "materials", index), "name");
            name = given && given->is_string() ? given->get<std::string>() : fmt::format("material {}", index);
        }
        // Names need not differ in glTF; `--set materials.NAME` needs it.
        return names.insert(name).second ? name : fmt::format("{} ({})", name, index);
    }

    const GltfFile &file;
    const std::string prefix;
    const scene::Bounds box;
    scene::Scene &scene;
    Maps &maps;
    std::map<int, std::uint32_t> known;
    std::set<std::string> names;
};

// `name` begins the objects' names, `prefix` those of the materials.
void add_objects(const GltfFile &file, const std::string &name, const std::string &prefix, const Transform &transform,
                 std::optional<bool> smooth, scene::Scene &scene, Maps &maps) {
    warn_of_file(file, scene.warnings);
    const std::size_t first = scene.objects.size();
    std::vector<int> materials;
    for (Part &part : read_parts(file, scene.warnings)) {
        scene.objects.push_back(make_object(name + ": " + part.name, std::move(part.mesh), transform, smooth,
                                            file.subject + ": " + part.name, scene.warnings));
        materials.push_back(part.material);
    }
    scene::Bounds box;
    for (std::size_t i = first; i < scene.objects.size(); ++i) box.extend(scene::bounds(scene.objects[i].mesh));
    Materials of_file(file, prefix, box, scene, maps);
    for (std::size_t i = first; i < scene.objects.size(); ++i)
        scene.objects[i].material = of_file.get(materials[i - first]);
}

bool emits(const scene::Material &material) {
    return material[shared::PARAMETER_emission_luminance].value.maxCoeff() > 0;
}

} // namespace

scene::Mesh load_gltf_mesh(const std::filesystem::path &path, std::vector<std::string> &warnings) {
    scene::Mesh whole;
    for (Part &part : read_parts(load_gltf_file(path), warnings)) scene::append(whole, std::move(part.mesh));
    return whole;
}

void add_gltf_objects(const std::filesystem::path &path, const std::string &name, const Transform &transform,
                      std::optional<bool> smooth, scene::Scene &scene, Maps &maps) {
    add_objects(load_gltf_file(path), name, path.filename().string() + ": ", transform, smooth, scene, maps);
}

Json load_gltf_scene(const std::filesystem::path &path, scene::Scene &scene, Maps &maps) {
    const GltfFile file = load_gltf_file(path);
    add_objects(file, path.filename().string(), "", Transform::Identity(), {}, scene, maps);
    const scene::Bounds box = scene::bounds(scene.objects);

    Json tree = Json::object();
    tree["materials"] = Json::object(); // the scene has them; their names are what `--set` may name
    for (const scene::Material &material : scene.materials) tree["materials"][material.name] = Json::object();
    const std::vector<GltfNode> nodes = place_nodes(file);
    if (const Json camera = read_gltf_camera(file, nodes, box, scene.warnings); !camera.is_null())
        tree["camera"] = camera;
    tree["lights"] = read_gltf_lights(file, nodes, scene.warnings);
    if (tree["lights"].empty() && std::none_of(scene.materials.begin(), scene.materials.end(), emits))
        tree["lights"] = default_lights(box);
    return tree;
}

} // namespace nacre::io
