#include "base/error.h"
#include "io/find_file.h"
#include "io/mesh_file.h"
#include "io/polygon.h"
#include <map>
#include <numeric>
#include <sstream>
#include <tiny_obj_loader.h>
#include <tuple>

namespace nacre::io {

namespace {

// OBJ indexes positions, normals and uvs apart; a mesh has one index for all three.
class Unifier {
  public:
    Unifier(const tinyobj::attrib_t &attributes, const std::string &subject)
        : attributes(attributes), subject(subject) {}

    std::uint32_t vertex(const tinyobj::index_t &index) {
        const auto key = std::make_tuple(index.vertex_index, index.normal_index, index.texcoord_index);
        const auto [entry, is_new] = known.try_emplace(key, static_cast<std::uint32_t>(mesh.positions.size()));
        if (is_new) add(index);
        return entry->second;
    }

    // A face without normals or uvs makes those of the others useless: a mesh has one for each vertex, or none.
    scene::Mesh finish() {
        if (missing_normals) mesh.normals.clear();
        if (missing_uvs == mesh.positions.size()) mesh.uvs.clear();
        return std::move(mesh);
    }

    scene::Mesh mesh;
    std::size_t missing_normals = 0, missing_uvs = 0; // vertices

  private:
    const float *at(const std::vector<float> &values, int index, std::size_t width, const char *what) const {
        if (index < 0 || (static_cast<std::size_t>(index) + 1) * width > values.size())
            input_error(subject, "a face names {} {}, there are {}", what, index + 1, values.size() / width);
        return values.data() + index * width;
    }

    void add(const tinyobj::index_t &index) {
        const float *position = at(attributes.vertices, index.vertex_index, 3, "vertex");
        mesh.positions.emplace_back(position[0], position[1], position[2]);
        mesh.normals.push_back(Vec3f::Zero());
        if (index.normal_index != absent)
            mesh.normals.back() = Vec3f(at(attributes.normals, index.normal_index, 3, "normal"));
        else
            ++missing_normals;
        mesh.uvs.push_back(Vec2f::Zero());
        if (index.texcoord_index != absent)
            mesh.uvs.back() = Vec2f(at(attributes.texcoords, index.texcoord_index, 2, "uv"));
        else
            ++missing_uvs;
    }

    static constexpr int absent = -1; // tinyobj's index where a face names no normal or uv

    const tinyobj::attrib_t &attributes;
    const std::string &subject;
    std::map<std::tuple<int, int, int>, std::uint32_t> known;
};

} // namespace

scene::Mesh load_obj(const std::filesystem::path &file, std::vector<std::string> &warnings) {
    const std::string subject = file.string();
    std::istringstream stream(read_file(file));
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    // Polygons are cut here: tinyobj's own way drops faces with bad indices and measures corners in absolute units.
    if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &stream, nullptr, false, false))
        input_error(subject, "is not a valid OBJ file: {}", error.substr(0, error.find('\n')));

    Unifier unifier(attributes, subject);
    std::vector<std::uint32_t> corners;
    for (const tinyobj::shape_t &shape : shapes) {
        const auto &counts = shape.mesh.num_face_vertices; // bytes: 256 wraps
        if (std::accumulate(counts.begin(), counts.end(), std::size_t{0}) != shape.mesh.indices.size())
            input_error(subject, "a face has more than 255 vertices, cut it into smaller ones");
        auto index = shape.mesh.indices.begin();
        for (const std::size_t count : counts) {
            corners.clear();
            for (std::size_t i = 0; i < count; ++i) corners.push_back(unifier.vertex(*index++));
            add_polygon(unifier.mesh, corners);
        }
    }
    if (!attributes.normals.empty() && unifier.missing_normals)
        warnings.push_back(subject + ": some faces have no normals, so those of the others are not used");
    if (warning.find("not found in .mtl") != std::string::npos)
        warnings.push_back(subject + ": its materials are not used");
    return unifier.finish();
}

} // namespace nacre::io
