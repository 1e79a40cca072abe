#include "io/gltf_mesh.h"
#include "base/error.h"
#include "io/gltf_accessor.h"
#include "io/mesh_file.h"
#include "scene/merge.h"

namespace nacre::io {

namespace {

int attribute(const tinygltf::Primitive &primitive, const char *name) {
    const auto found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? -1 : found->second;
}

std::vector<std::uint32_t> read_indices(const GltfFile &file, const tinygltf::Primitive &primitive,
                                        const std::string &where, std::size_t vertices) {
    std::vector<std::uint32_t> indices;
    if (primitive.indices == -1) {
        for (std::size_t i = 0; i < vertices; ++i) indices.push_back(static_cast<std::uint32_t>(i));
        return indices;
    }
    for (const double index : read_accessor(file, primitive.indices, 1)) {
        if (!(index >= 0) || index >= static_cast<double>(vertices) || index != std::floor(index))
            input_error(where, "an index is {}, there are {} vertices", index, vertices);
        indices.push_back(static_cast<std::uint32_t>(index));
    }
    return indices;
}

// glTF 2.0, section 3.7.2.1: how lists, strips and fans name their triangles.
void add_triangles(scene::Mesh &mesh, const std::vector<std::uint32_t> &indices, int mode, const std::string &where) {
    if (mode == TINYGLTF_MODE_TRIANGLES && indices.size() % 3 != 0)
        input_error(where, "{} indices are not whole triangles", indices.size());
    const std::size_t step = mode == TINYGLTF_MODE_TRIANGLES ? 3 : 1;
    for (std::size_t i = 0; i + 2 < indices.size(); i += step) {
        const bool flipped = mode == TINYGLTF_MODE_TRIANGLE_STRIP && i % 2 == 1;
        const std::uint32_t first = mode == TINYGLTF_MODE_TRIANGLE_FAN ? indices[0] : indices[i];
        mesh.triangles.push_back({first, indices[i + (flipped ? 2 : 1)], indices[i + (flipped ? 1 : 2)]});
    }
}

scene::Mesh read_primitive(const GltfFile &file, const tinygltf::Primitive &primitive, const std::string &where) {
    scene::Mesh mesh;
    if (attribute(primitive, "POSITION") < 0) input_error(where, "has no positions");
    const std::vector<double> positions = read_accessor(file, attribute(primitive, "POSITION"), 3);
    const std::size_t count = positions.size() / 3;
    for (std::size_t i = 0; i < count; ++i)
        mesh.positions.emplace_back(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]);

    const auto same_count = [&](const char *name, std::size_t other) {
        if (other != count) input_error(where, "has {} of {}, but {} positions", other, name, count);
    };
    if (const int index = attribute(primitive, "NORMAL"); index >= 0) {
        const std::vector<double> normals = read_accessor(file, index, 3);
        same_count("NORMAL", normals.size() / 3);
        for (std::size_t i = 0; i < count; ++i)
            mesh.normals.push_back(Vec3(normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]).cast<float>());
    }
    if (const int index = attribute(primitive, "TEXCOORD_0"); index >= 0) {
        const std::vector<double> uvs = read_accessor(file, index, 2);
        same_count("TEXCOORD_0", uvs.size() / 2);
        for (std::size_t i = 0; i < count; ++i) // glTF's v goes down
            mesh.uvs.push_back(Vec2(uvs[2 * i], 1 - uvs[2 * i + 1]).cast<float>());
    }
    add_triangles(mesh, read_indices(file, primitive, where, count), primitive.mode, where);
    return mesh;
}

} // namespace

std::map<int, scene::Mesh> read_gltf_mesh(const GltfFile &file, int index, std::vector<std::string> &warnings) {
    if (index < 0 || static_cast<std::size_t>(index) >= file.model.meshes.size())
        input_error(file.subject, "a node names mesh {}, there are {}", index, file.model.meshes.size());
    std::map<int, scene::Mesh> meshes;
    const auto &primitives = file.model.meshes[index].primitives;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        const tinygltf::Primitive &primitive = primitives[i];
        const std::string where = fmt::format("{}: meshes.{}.primitives.{}", file.subject, index, i);
        if (primitive.mode < TINYGLTF_MODE_TRIANGLES || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN) {
            warnings.push_back(where + ": points and lines are not drawn");
            continue;
        }
        if (!primitive.targets.empty()) warnings.push_back(where + ": morph targets are not used");
        if (attribute(primitive, "COLOR_0") >= 0) warnings.push_back(where + ": vertex colours are not used");
        scene::Mesh mesh = read_primitive(file, primitive, where);
        check_mesh(mesh, where);
        scene::append(meshes[primitive.material], std::move(mesh));
    }
    return meshes;
}

} // namespace nacre::io
