#pragma once
#include "host/mesh_files.h"
#include "io/tree.h"
#include <vector>

namespace nacre {

/// Puts a glTF file together piece by piece.
class GltfBuilder {
  public:
    io::Json json = {{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", io::Json::array()}}}}};
    std::string binary;

    /// Adds the numbers as a buffer view of their own; returns its index.
    template <typename T> int add_view(const std::vector<T> &values) {
        while (binary.size() % 4) binary.push_back('\0');
        json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", values.size() * sizeof(T)}});
        for (const T value : values) binary += bytes_as(value);
        return last("bufferViews");
    }

    /// Adds an accessor; `type` "VEC3", `component` 5126 (float). Returns its index.
    template <typename T>
    int add_accessor(const std::vector<T> &values, const char *type, int component, std::size_t count) {
        const int view = add_view(values);
        json["accessors"].push_back(
            {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
        return last("accessors");
    }

    int add_positions(const std::vector<float> &values) {
        return add_accessor(values, "VEC3", 5126, values.size() / 3);
    }

    /// Adds a mesh of one primitive; returns its index.
    int add_mesh(const io::Json &primitive) {
        json["meshes"].push_back({{"primitives", io::Json::array({primitive})}});
        return last("meshes");
    }

    /// Adds a node to the scene.
    int add_node(const io::Json &node) {
        json["nodes"].push_back(node);
        json["scenes"][0]["nodes"].push_back(last("nodes"));
        return last("nodes");
    }

    /// A tetrahedron with corners at the origin and at 1, 2, 3 on the axes, as a mesh of `material` (-1: none).
    int add_tetrahedron(int material = -1) {
        const int positions = add_positions({0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3});
        const int indices = add_accessor<std::uint16_t>({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}, "SCALAR", 5123, 12);
        io::Json primitive = {{"attributes", {{"POSITION", positions}}}, {"indices", indices}};
        if (material >= 0) primitive["material"] = material;
        return add_mesh(primitive);
    }

    std::string glb() const {
        io::Json whole = json;
        whole["buffers"] = {{{"byteLength", binary.size()}}};
        std::string text = whole.dump(), bin = binary;
        text.append((4 - text.size() % 4) % 4, ' ');
        bin.append((4 - bin.size() % 4) % 4, '\0');
        const auto number = [](std::size_t value) { return bytes_as(static_cast<std::uint32_t>(value)); };
        return number(0x46546C67) + number(2) + number(28 + text.size() + bin.size()) + number(text.size()) +
               number(0x4E4F534A) + text + number(bin.size()) + number(0x004E4942) + bin;
    }

  private:
    int last(const char *section) const { return static_cast<int>(json.at(section).size()) - 1; }
};

} // namespace nacre
