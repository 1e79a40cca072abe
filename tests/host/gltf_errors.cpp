#include "host/gltf_builder.h"
#include "host/scene_folder.h"
#include <functional>
#include <limits>

namespace nacre {
namespace {

using io::Json;

class GltfErrors : public SceneFolder {
  protected:
    void expect_error(const std::string &bytes, const std::string &fragment, const char *name = "s.glb") {
        put(folder / name, bytes);
        const std::string message = error_of(name);
        EXPECT_NE(message.find(fragment), std::string::npos) << "'" << message << "' lacks '" << fragment << "'";
        EXPECT_TRUE(message.starts_with((folder / name).string())) << message;
    }
};

// A good file, to spoil in one place. Accessors: 0 positions, 1 indices.
GltfBuilder good() {
    GltfBuilder builder;
    builder.add_node({{"mesh", builder.add_tetrahedron()}});
    return builder;
}

TEST_F(GltfErrors, IndicesOutOfRange) {
    const struct {
        std::function<void(Json &)> spoil;
        std::string fragment;
    } cases[] = {
        {[](Json &j) { j["scene"] = 4; }, "there is no scene 4"},
        {[](Json &j) { j["scenes"][0]["nodes"] = {7}; }, "there is no node 7"},
        {[](Json &j) { j["scenes"][0]["nodes"] = {-1}; }, "there is no node -1"},
        {[](Json &j) { j["scenes"][0]["nodes"] = Json::array(); }, "has no triangles"},
        {[](Json &j) { j["nodes"][0]["children"] = {0}; }, "its own ancestor"},
        {[](Json &j) { j["nodes"][0]["mesh"] = 3; }, "a node names mesh 3, there are 1"},
        {[](Json &j) { j["nodes"][0]["mesh"] = -5; }, "a node names mesh -5"},
        {[](Json &j) { j["nodes"][0]["camera"] = 3; }, "there is no camera 3"},
        {[](Json &j) {
             j["nodes"][0]["matrix"] = {1, 2, 3};
         },
         "matrix has 3 numbers, not 16"},
        {[](Json &j) {
             j["nodes"][0]["rotation"] = {0, 0, 0, 0};
         },
         "rotation has no length"},
        {[](Json &j) {
             j["nodes"][0]["scale"] = {0, 0, 0};
         },
         "none of its 4 triangles has an area"},
        {[](Json &j) { j["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0; }, "there is no light 0"},
        {[](Json &j) { j["meshes"][0]["primitives"][0]["material"] = 2; }, "materials: there is no element 2"},
        {[](Json &j) { j["meshes"][0]["primitives"][0]["material"] = -7; }, "materials: there is no element -7"},
        {[](Json &j) { j["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 9; }, "only 2 accessors"},
        {[](Json &j) { j["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = 1; }, "3 are expected"},
        {[](Json &j) { j["meshes"][0]["primitives"][0]["attributes"].erase("POSITION"); }, "has no positions"},
        {[](Json &j) { j["meshes"][0]["primitives"][0]["indices"] = 9; }, "out of bounds"},
        {[](Json &j) { j["meshes"][0]["primitives"][0]["indices"] = 0; }, "has 3 numbers per element, 1 are"},
        {[](Json &j) { j["meshes"][0]["primitives"][0]["mode"] = 1; }, "has no triangles"},
        {[](Json &j) { j["accessors"][0]["count"] = 3; }, "an index is 3, there are 3 vertices"},
        {[](Json &j) { j["accessors"][0]["count"] = 5; }, "5 elements go beyond buffer view 0"},
        {[](Json &j) { j["accessors"][0]["count"] = 18446744073709551615ull; }, "go beyond buffer view 0"},
        {[](Json &j) { j["accessors"][0]["byteOffset"] = 4; }, "4 elements go beyond buffer view 0"},
        {[](Json &j) { j["accessors"][0]["byteOffset"] = 18446744073709551612ull; }, "go beyond buffer view 0"},
        {[](Json &j) { j["accessors"][0]["bufferView"] = 99; }, "names buffer view 99, there are 2"},
        {[](Json &j) { j["accessors"][0].erase("bufferView"), j["accessors"][0]["count"] = 1000000000000000; },
         "without a buffer"},
        {[](Json &j) { j["accessors"][0]["componentType"] = 5124; }, "components of type 5124"},
        {[](Json &j) { j["accessors"][0]["type"] = "VEC9"; }, "is not valid glTF"},
        {[](Json &j) { j["accessors"][1]["count"] = 11; }, "11 indices are not whole triangles"},
        {[](Json &j) { j["bufferViews"][0]["buffer"] = 1; }, "names buffer 1, there are 1"},
        {[](Json &j) { j["bufferViews"][0]["buffer"] = -1; }, "names buffer -1"},
        {[](Json &j) { j["bufferViews"][0]["byteLength"] = 1000; }, "goes beyond its buffer"},
        {[](Json &j) { j["bufferViews"][0]["byteOffset"] = 18446744073709551000ull; }, "goes beyond its buffer"},
        {[](Json &j) { j["bufferViews"][0]["byteStride"] = 252; }, "go beyond buffer view 0"},
        {[](Json &j) { j["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }, "KHR_draco_mesh_compression"},
        {[](Json &j) { j["asset"] = 3, j["nodes"] = 3; }, "there is no node 0"},
        {[](Json &j) { j["meshes"] = {3}; }, "is not valid glTF"},
    };
    put(folder / "good.glb", good().glb());
    ASSERT_EQ(error_of("good.glb"), "");
    for (const auto &[spoil, fragment] : cases) {
        GltfBuilder builder = good();
        spoil(builder.json);
        expect_error(builder.glb(), fragment);
    }
}

TEST_F(GltfErrors, Contents) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        GltfBuilder builder = good();
        builder.binary.replace(12, 4, bytes_as(bad));
        expect_error(builder.glb(), "vertex 1 is at (");
    }
    GltfBuilder sparse = good();
    const int index = sparse.add_view<std::uint8_t>({200}), value = sparse.add_view<float>({0, 0, 0});
    sparse.json["accessors"][0]["sparse"] = {{"count", 1},
                                             {"indices", {{"bufferView", index}, {"componentType", 5121}}},
                                             {"values", {{"bufferView", value}}}};
    expect_error(sparse.glb(), "names element 200 of 4");
    sparse.json["accessors"][0]["sparse"]["count"] = -1;
    expect_error(sparse.glb(), "negative count");
    sparse.json["accessors"][0]["sparse"]["count"] = 2;
    expect_error(sparse.glb(), "2 elements go beyond buffer view");

    GltfBuilder image = good();
    image.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    image.json["meshes"][0]["primitives"][0]["material"] = 0;
    image.json["textures"] = {{{"source", 0}}};
    image.json["images"] = {{{"uri", "gone.png"}}};
    expect_error(image.glb(), "there is no file 'gone.png'");
    image.json["images"] = {{{"bufferView", 77}, {"mimeType", "image/png"}}};
    expect_error(image.glb(), "there is no buffer view 77");
    image.json["images"] = {{{"bufferView", 0}, {"mimeType", "image/png"}}};
    expect_error(image.glb(), "images.0");
    image.json["bufferViews"][0]["byteOffset"] = 1000000;
    expect_error(image.glb(), "goes beyond");
}

TEST_F(GltfErrors, Containers) {
    const std::string glb = good().glb();
    for (std::size_t size = 0; size < glb.size(); ++size) { // every truncation
        put(folder / "s.glb", glb.substr(0, size));
        EXPECT_NE(error_of("s.glb"), "") << size;
    }
    expect_error("glTX" + glb.substr(4), "is not a GLB file");
    expect_error(glb.substr(0, 4) + bytes_as<std::uint32_t>(1) + glb.substr(8), "glTF version 1");
    expect_error(glb.substr(0, 12) + bytes_as<std::uint32_t>(0xffffffff) + glb.substr(16), "does not fit");
    expect_error("{", "not valid JSON", "s.gltf");
    expect_error("[]", "expected an object", "s.gltf");
    expect_error("{}", "is not valid glTF", "s.gltf");
    expect_error(R"({"asset": {"version": "2.0"}})", "has no triangles", "s.gltf");
    expect_error(std::string(100000, '['), "nested deeper", "s.gltf");
    expect_error(R"({"buffers": [{"byteLength": 4, "uri": "gone.bin"}]})", "gone.bin", "s.gltf");
    // A name is a name, not a command for a shell.
    expect_error(R"json({"buffers": [{"byteLength": 4, "uri": "$(touch pwned)"}]})json", "touch pwned", "s.gltf");
    EXPECT_FALSE(std::filesystem::exists("pwned"));
    expect_error(R"({"buffers": [{"byteLength": 0, "uri": "data:application/octet-stream;base64,"}]})", "not valid",
                 "s.gltf");
}

} // namespace
} // namespace nacre
