#include "host/gltf_builder.h"
#include "host/scene_folder.h"
#include <random>

namespace nacre {
namespace {

// Files with random damage either load or throw Error: nothing else, and no crash (sanitizers see more).
class Fuzz : public SceneFolder {
  protected:
    void run(const std::string &name, const std::string &good, int rounds) {
        put(folder / name, good);
        ASSERT_EQ(error_of(name), "");
        std::mt19937 random(20240917); // the same damage every time
        int loaded = 0;
        for (int round = 0; round < rounds; ++round) {
            put(folder / name, damaged(good, random));
            loaded += error_of(name).empty(); // anything but Error fails the test
        }
        // Damage that never, or always, loads would test little.
        EXPECT_GT(loaded, 0);
        EXPECT_LT(loaded, rounds);
    }

  private:
    static std::string damaged(std::string bytes, std::mt19937 &random) {
        const auto pick = [&](std::size_t count) { return random() % std::max<std::size_t>(count, 1); };
        for (std::size_t edits = 1 + pick(3); edits > 0 && !bytes.empty(); --edits) {
            const std::size_t at = pick(bytes.size());
            switch (pick(6)) {
            case 0: bytes[at] = static_cast<char>(random()); break;
            case 1: bytes[at] ^= static_cast<char>(1 << pick(8)); break;
            case 2: bytes[at] = "0123456789-.,:[]{}\"e "[pick(20)]; break; // numbers and structure of the text formats
            case 3: bytes.erase(at, 1 + pick(8)); break;
            case 4: bytes.insert(at, bytes.substr(pick(bytes.size()), 1 + pick(16))); break;
            case 5:
                if (pick(4) == 0) bytes.resize(at);
            }
        }
        return bytes;
    }
};

TEST_F(Fuzz, Glb) {
    GltfBuilder builder;
    builder.json["materials"] = {{{"name", "m"},
                                  {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                                  {"extensions",
                                   {{"KHR_materials_volume", {{"attenuationDistance", 1}}},
                                    {"KHR_materials_transmission", {{"transmissionFactor", 1}}},
                                    {"KHR_materials_volume_scatter", {{"scatterAnisotropy", 0.5}}}}},
                                  {"extras", {{"nacre", {{"subsurface_bleed", 0.5}}}}}}};
    builder.json["textures"] = {{{"source", 0}}};
    builder.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}}};
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}, {"intensity", 5}}};
    builder.json["images"] = {{{"uri", "red.ppm"}}};
    put(folder / "red.ppm", red_pixel);
    builder.add_node({{"mesh", builder.add_tetrahedron(0)}, {"children", {1}}});
    builder.json["nodes"].push_back(
        {{"camera", 0}, {"translation", {0, 0, 9}}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    const int normals = builder.add_positions({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    builder.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = normals;
    run("m.glb", builder.glb(), 1500);
}

TEST_F(Fuzz, Ply) {
    run("a.ply", tetrahedron_ply("ascii"), 500);
    run("b.ply", tetrahedron_ply("binary_little_endian"), 500);
}

TEST_F(Fuzz, Obj) { run("m.obj", "vn 0 0 1\nvt 0 1\n" + tetrahedron_obj + "f 1/1/1 2/1/1 3/1/1 4/1/1 2/1/1\n", 500); }

TEST_F(Fuzz, Json) {
    put(folder / "m.obj", tetrahedron_obj);
    put(folder / "red.ppm", red_pixel);
    run("m.json", R"({"camera": {"fov": 40, "position": [0, 0, 9]}, "image": {"width": 64, "height": 48},
        "materials": {"wax": {"subsurface_weight": 1, "subsurface_color": {"texture": "red.ppm"},
                              "subsurface_radius_scale": [1, 0.5, 0.25], "subsurface_flight": "reciprocal"}},
        "objects": [{"mesh": "m.obj", "material": "wax", "transform": {"rotate": [10, 20, 30]}},
                    {"sphere": {"radius": 0.5, "segments": 8}}, {"box": {"min": [0, 0, 0], "max": [1, 2, 3]}}],
        "lights": [{"type": "rect", "u": [1, 0, 0], "v": [0, 1, 0], "radiance": [1, 2, 3]}]})",
        1000);
}

} // namespace
} // namespace nacre
