#include "host/gltf_builder.h"
#include "host/scene_folder.h"
#include "scene/topology.h"
#include <numbers>

namespace nacre {
namespace {

using namespace shared;
using io::Json;

class Gltf : public SceneFolder {
  protected:
    scene::Scene load_built(const GltfBuilder &builder, const std::vector<io::Override> &overrides = {}) {
        put(folder / "s.glb", builder.glb());
        return load("s.glb", overrides);
    }

    // The position of each corner of each triangle.
    static std::vector<Vec3> corners(const scene::Mesh &mesh) {
        std::vector<Vec3> result;
        for (const auto &triangle : mesh.triangles)
            for (const std::uint32_t vertex : triangle) result.push_back(mesh.positions[vertex]);
        return result;
    }
};

double volume(const scene::Scene &scene) { return scene::find_topology(scene.objects.at(0).mesh).shells.at(0).volume; }

TEST_F(Gltf, ReadsAGlbWithDefaults) {
    GltfBuilder builder;
    builder.add_node({{"mesh", builder.add_tetrahedron()}, {"name", "tet"}});
    const scene::Scene s = load_built(builder);
    ASSERT_EQ(s.objects.size(), 1u);
    EXPECT_EQ(s.objects[0].name, "s.glb: tet");
    EXPECT_NEAR(volume(s), 1, 1e-6);
    EXPECT_EQ(s.lights.size(), 3u); // those of a bare mesh
    EXPECT_EQ(s.materials.at(0).name, "default");
    EXPECT_NEAR(s.materials[0][PARAMETER_subsurface_radius].value.x(), 0.02 * std::sqrt(14), 1e-6);
    EXPECT_GT(s.camera.position.z(), 3);
    EXPECT_TRUE(s.warnings.empty());
}

TEST_F(Gltf, ReadsGltfWithBuffersBesideItAndInIt) {
    GltfBuilder builder;
    builder.add_node({{"mesh", builder.add_tetrahedron()}});
    put(folder / "my data.bin", builder.binary);
    builder.json["buffers"] = {{{"byteLength", builder.binary.size()}, {"uri", "my%20data.bin"}}};
    put(folder / "s.gltf", builder.json.dump());
    EXPECT_NEAR(volume(load("s.gltf")), 1, 1e-6);

    GltfBuilder small;
    const int positions = small.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    small.add_node({{"mesh", small.add_mesh({{"attributes", {{"POSITION", positions}}}})}});
    // 36 bytes: zero but for two ones (00 00 80 3f) at bytes 12 and 28.
    small.json["buffers"] = {{{"byteLength", 36},
                              {"uri", "data:application/octet-stream;base64,"
                                      "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}}};
    put(folder / "s.gltf", small.json.dump());
    EXPECT_EQ(corners(load("s.gltf").objects.at(0).mesh).at(1), Vec3(1, 0, 0));
}

TEST_F(Gltf, NodesPlaceMeshes) {
    GltfBuilder builder;
    const int mesh = builder.add_tetrahedron();
    const double r = std::sqrt(0.5);
    builder.add_node({{"children", {1}}, {"translation", {10, 0, 0}}, {"scale", {2, 2, 2}}});
    builder.json["nodes"].push_back({{"mesh", mesh}, {"rotation", {0, 0, r, r}}}); // 90 degrees about z
    builder.add_node({{"mesh", mesh}, {"matrix", {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 5, 1}}}); // mirrored
    const scene::Scene s = load_built(builder);
    ASSERT_EQ(s.objects.size(), 2u);
    const scene::Scene &const_s = s;
    const auto find = [&](int object, const Vec3 &corner) {
        for (const Vec3 &p : corners(const_s.objects[object].mesh))
            if ((p - corner).norm() < 1e-6) return true;
        return false;
    };
    EXPECT_TRUE(find(0, {-1, 0, 5})); // parents come before children, so the mirrored one is first
    EXPECT_GT(scene::find_topology(s.objects[0].mesh).shells[0].volume, 0);
    EXPECT_TRUE(find(1, {10, 2, 0})); // (1,0,0) -> (0,1,0) -> (0,2,0) -> (10,2,0)
    EXPECT_TRUE(find(1, {6, 0, 0}));  // (0,2,0) -> (-2,0,0) -> (-4,0,0) -> (6,0,0)
}

TEST_F(Gltf, ListsStripsAndFansWithAndWithoutIndices) {
    const std::vector<float> square{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    const struct {
        int mode;
        std::vector<std::uint8_t> indices;
    } cases[] = {{4, {0, 1, 2, 0, 2, 3}}, {5, {0, 1, 3, 2}}, {6, {0, 1, 2, 3}}, {6, {}}};
    for (const auto &[mode, indices] : cases) {
        GltfBuilder builder;
        Json primitive = {{"attributes", {{"POSITION", builder.add_positions(square)}}}, {"mode", mode}};
        if (!indices.empty()) primitive["indices"] = builder.add_accessor(indices, "SCALAR", 5121, indices.size());
        builder.add_node({{"mesh", builder.add_mesh(primitive)}});
        const scene::Scene s = load_built(builder);
        const std::vector<Vec3> at = corners(s.objects[0].mesh);
        ASSERT_EQ(at.size(), 6u) << mode;
        double area = 0;
        for (int i = 0; i < 6; i += 3) {
            const double signed_area = (at[i + 1] - at[i]).cross(at[i + 2] - at[i]).z() / 2;
            EXPECT_GT(signed_area, 0) << mode; // none turned round
            area += signed_area;
        }
        EXPECT_NEAR(area, 1, 1e-6);
    }
}

TEST_F(Gltf, NormalizedStridedAndSparseAccessors) {
    GltfBuilder builder;
    // Positions as normalised shorts with a stride of 8.
    const int packed = builder.add_view<std::int16_t>({0, 0, 0, 0, 32767, 0, 0, 0, 0, -32768, 0, 0, 5, 0, 0, 0});
    builder.json["bufferViews"][packed]["byteStride"] = 8;
    const int replaced = builder.add_view<std::uint8_t>({3});
    const int values = builder.add_view<std::int16_t>({0, 0, 32767});
    builder.json["accessors"].push_back({{"bufferView", packed},
                                         {"componentType", 5122},
                                         {"normalized", true},
                                         {"count", 4},
                                         {"type", "VEC3"},
                                         {"sparse",
                                          {{"count", 1},
                                           {"indices", {{"bufferView", replaced}, {"componentType", 5121}}},
                                           {"values", {{"bufferView", values}}}}}});
    const int uvs = builder.add_accessor<std::uint8_t>({0, 0, 255, 0, 0, 255, 255, 255}, "VEC2", 5121, 4);
    builder.json["accessors"][uvs]["normalized"] = true;
    const int indices = builder.add_accessor<std::uint32_t>({0, 1, 2, 1, 3, 2}, "SCALAR", 5125, 6);
    builder.add_node(
        {{"mesh", builder.add_mesh({{"attributes", {{"POSITION", 0}, {"TEXCOORD_0", uvs}}}, {"indices", indices}})}});
    const scene::Mesh mesh = load_built(builder).objects[0].mesh;
    ASSERT_EQ(mesh.positions.size(), 4u);
    EXPECT_EQ(mesh.positions[1], Vec3(1, 0, 0));
    EXPECT_EQ(mesh.positions[2], Vec3(0, -1, 0)); // -32768 is -1, as -32767 is
    EXPECT_EQ(mesh.positions[3], Vec3(0, 0, 1));  // the sparse one
    EXPECT_EQ(mesh.uvs[1], Vec2f(1, 1));          // v goes up here, down in glTF
    EXPECT_EQ(mesh.uvs[2], Vec2f(0, 0));
}

TEST_F(Gltf, CameraAndLightsAreThoseOfTheFile) {
    GltfBuilder builder;
    builder.json["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}},
        {{"type", "orthographic"}, {"orthographic", {{"xmag", 3}, {"ymag", 2}, {"zfar", 9}, {"znear", 0.1}}}}};
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "point"}, {"intensity", 5}, {"color", {1, 0.5, 0}}},
        {{"type", "directional"}, {"intensity", 3}},
        {{"type", "spot"}, {"intensity", 2}}};
    const double r = std::sqrt(0.5);
    const auto light = [](int index) { return Json{{"KHR_lights_punctual", {{"light", index}}}}; };
    builder.add_node({{"mesh", builder.add_tetrahedron()}});
    builder.add_node({{"camera", 0}, {"translation", {5, 0, 0}}, {"rotation", {0, r, 0, r}}}); // looks along -x
    builder.add_node({{"camera", 1}});
    builder.add_node({{"translation", {1, 2, 3}}, {"extensions", light(0)}});
    builder.add_node({{"rotation", {-r, 0, 0, r}}, {"extensions", light(1)}}); // -z -> -y
    builder.add_node({{"extensions", light(2)}});
    const scene::Scene s = load_built(builder);
    EXPECT_EQ(s.camera.kind, CAMERA_PERSPECTIVE);
    EXPECT_NEAR(s.camera.fov, 0.5 * 180 / std::numbers::pi, 1e-9);
    EXPECT_EQ(s.camera.position, Vec3(5, 0, 0));
    EXPECT_LT(((s.camera.target - s.camera.position).normalized() - Vec3(-1, 0, 0)).norm(), 1e-9);
    EXPECT_NEAR(s.camera.target.x(), 0.5, 1e-9); // as deep as the middle of the objects
    ASSERT_EQ(s.lights.size(), 3u);
    EXPECT_EQ(s.lights[0].kind, LIGHT_POINT);
    EXPECT_EQ(s.lights[0].position, Vec3(1, 2, 3));
    EXPECT_EQ(s.lights[0].radiance, Vec3(5, 2.5, 0));
    EXPECT_EQ(s.lights[1].kind, LIGHT_DIRECTIONAL);
    EXPECT_LT((s.lights[1].direction - Vec3(0, -1, 0)).norm(), 1e-9);
    EXPECT_EQ(s.lights[1].radiance, Vec3(3, 3, 3));
    EXPECT_EQ(s.lights[2].kind, LIGHT_POINT);
    ASSERT_EQ(s.warnings.size(), 2u); // two cameras; the spot
}

TEST_F(Gltf, OrthographicCameraAndOverrides) {
    GltfBuilder builder;
    builder.json["cameras"] = {
        {{"type", "orthographic"}, {"orthographic", {{"xmag", 3}, {"ymag", 2}, {"zfar", 9}, {"znear", 0.1}}}}};
    builder.json["materials"] = {{{"name", "wax"}}};
    builder.add_node({{"mesh", builder.add_tetrahedron(0)}});
    builder.add_node({{"camera", 0}, {"translation", {0, 0, 9}}});
    const scene::Scene s = load_built(builder, {{"materials.wax.subsurface_weight", "0.5"},
                                                {"lights.0.radiance", "9"},
                                                {"camera.aperture", "0.25"},
                                                {"render.spp", "2"}});
    EXPECT_EQ(s.camera.kind, CAMERA_ORTHOGRAPHIC);
    EXPECT_EQ(s.camera.height, 4);
    EXPECT_EQ(s.camera.aperture, 0.25);
    EXPECT_EQ(s.materials[0][PARAMETER_subsurface_weight].value.x(), 0.5);
    EXPECT_EQ(s.materials[0][PARAMETER_base_metalness].value.x(), 1); // glTF's default stays
    EXPECT_EQ(s.lights[0].radiance, Vec3(9, 9, 9));
    EXPECT_EQ(s.render.spp, 2u);
    EXPECT_NE(error_of("s.glb", {{"materials.wacks.subsurface_weight", "1"}}).find("no such material"),
              std::string::npos);
}

TEST_F(Gltf, AnObjectOfAJsonSceneKeepsItsMaterialsUnlessItNamesOne) {
    GltfBuilder builder;
    builder.json["materials"] = {{{"name", "wax"}}, {{"name", "jade"}}};
    builder.add_node({{"mesh", builder.add_tetrahedron(0)}});
    builder.add_node({{"mesh", builder.add_tetrahedron(1)}, {"translation", {9, 0, 0}}});
    put(folder / "two.glb", builder.glb());
    const scene::Scene own = load_text(R"({"objects": [{"mesh": "two.glb", "transform": {"scale": 2}}]})");
    ASSERT_EQ(own.objects.size(), 2u);
    EXPECT_EQ(own.materials.at(own.objects[0].material).name, "two.glb: wax");
    EXPECT_EQ(own.materials.at(own.objects[1].material).name, "two.glb: jade");
    EXPECT_NEAR(volume(own), 8, 1e-6);
    const scene::Scene one =
        load_text(R"({"materials": {"m": {}}, "objects": [{"mesh": "two.glb", "material": "m"}]})");
    ASSERT_EQ(one.objects.size(), 1u);
    EXPECT_EQ(one.materials.size(), 1u);
    EXPECT_EQ(one.objects[0].mesh.triangles.size(), 8u);
}

TEST_F(Gltf, NamesWhatItDoesNotUse) {
    GltfBuilder builder;
    builder.json["materials"] = {{{"occlusionTexture", {{"index", 0}}},
                                  {"alphaMode", "BLEND"},
                                  {"extensions", {{"KHR_materials_sheen", Json::object()}}}}};
    builder.json["animations"] = Json::array();
    builder.json["extensionsUsed"] = {"KHR_materials_sheen", "EXT_strange"};
    builder.json["skins"] = {{{"joints", {0}}}};
    builder.add_node({{"mesh", builder.add_tetrahedron(0)}, {"skin", 0}});
    builder.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}};
    std::string all;
    for (const std::string &warning : load_built(builder).warnings) all += warning + "\n";
    for (const char *word : {"occlusionTexture", "alphaMode", "KHR_materials_sheen", "animations", "EXT_strange",
                             "nodes.0: its skin", "morph targets"})
        EXPECT_NE(all.find(word), std::string::npos) << word << " is not in\n" << all;
}

} // namespace
} // namespace nacre
