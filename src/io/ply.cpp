#include "base/error.h"
#include "io/find_file.h"
#include "io/mesh_file.h"
#include "io/ply_body.h"
#include "io/polygon.h"
#include <algorithm>
#include <cmath>

namespace nacre::io {

namespace {

constexpr int absent = -1;

// The place of a property in its element, by the first of `names` that is there.
int find(const PlyElement &element, std::initializer_list<const char *> names) {
    for (const char *name : names)
        for (std::size_t i = 0; i < element.properties.size(); ++i)
            if (element.properties[i].name == name) return static_cast<int>(i);
    return absent;
}

// Reads all properties of one element; lists go to `lists`, by property.
void read_row(PlyBody &body, const PlyElement &element, std::vector<double> &numbers,
              std::vector<std::vector<double>> &lists) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const PlyProperty &property = element.properties[i];
        if (!property.list) {
            numbers[i] = body.next(property.type);
            continue;
        }
        lists[i].resize(body.next_count(property.count_type, property.type));
        for (double &item : lists[i]) item = body.next(property.type);
    }
}

struct Reader {
    PlyBody body;
    const std::string &subject;
    scene::Mesh mesh;

    void vertices(const PlyElement &element) {
        const int x = find(element, {"x"}), y = find(element, {"y"}), z = find(element, {"z"});
        const int nx = find(element, {"nx"}), ny = find(element, {"ny"}), nz = find(element, {"nz"});
        const int u = find(element, {"u", "s", "texture_u"}), v = find(element, {"v", "t", "texture_v"});
        if (x == absent || y == absent || z == absent) input_error(subject, "its vertices have no x, y and z");
        std::vector<double> row(element.properties.size());
        std::vector<std::vector<double>> lists(element.properties.size());
        for (std::size_t i = 0; i < element.count; ++i) {
            read_row(body, element, row, lists);
            mesh.positions.emplace_back(row[x], row[y], row[z]);
            if (nx != absent && ny != absent && nz != absent)
                mesh.normals.push_back(Vec3(row[nx], row[ny], row[nz]).cast<float>());
            if (u != absent && v != absent) mesh.uvs.push_back(Vec2(row[u], row[v]).cast<float>());
        }
    }

    void faces(const PlyElement &element) {
        const int corners = find(element, {"vertex_indices", "vertex_index"});
        if (corners == absent || !element.properties[corners].list)
            input_error(subject, "its faces have no list vertex_indices");
        std::vector<double> row(element.properties.size());
        std::vector<std::vector<double>> lists(element.properties.size());
        std::vector<std::uint32_t> polygon;
        for (std::size_t i = 0; i < element.count; ++i) {
            read_row(body, element, row, lists);
            polygon.clear();
            for (const double index : lists[corners]) {
                if (!(index >= 0) || index >= mesh.positions.size() || index != std::floor(index))
                    input_error(subject, "face {} names vertex {}, there are {}", i, index, mesh.positions.size());
                polygon.push_back(static_cast<std::uint32_t>(index));
            }
            add_polygon(mesh, polygon);
        }
    }

    void skip(const PlyElement &element) {
        std::vector<double> row(element.properties.size());
        std::vector<std::vector<double>> lists(element.properties.size());
        for (std::size_t i = 0; i < element.count; ++i) read_row(body, element, row, lists);
    }
};

} // namespace

scene::Mesh load_ply(const std::filesystem::path &file) {
    const std::string subject = file.string(), bytes = read_file(file);
    const PlyHeader header = parse_ply_header(bytes, subject);
    Reader reader{PlyBody(bytes, header, subject), subject, {}};
    const auto once = [&](const char *name) {
        return std::count_if(header.elements.begin(), header.elements.end(),
                             [&](const PlyElement &element) { return element.name == name; }) == 1;
    };
    if (!once("vertex") || !once("face")) input_error(subject, "needs one element 'vertex' and one 'face'");
    for (const PlyElement &element : header.elements) {
        reader.body.expect(element);
        if (element.name == "vertex")
            reader.vertices(element);
        else if (element.name == "face")
            reader.faces(element);
        else
            reader.skip(element);
    }
    return std::move(reader.mesh);
}

} // namespace nacre::io
