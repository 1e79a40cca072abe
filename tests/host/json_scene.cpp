#include "host/scene_folder.h"
#include <cstdlib>

namespace nacre {
namespace {

using namespace shared;
class JsonScene : public SceneFolder {};

const std::string one_sphere = R"("objects": [{"sphere": {"segments": 8}}])";

TEST_F(JsonScene, EveryFieldIsRead) {
    put(folder / "red.ppm", red_pixel);
    const scene::Scene s = load_text(R"({
      "camera": {"type": "orthographic", "position": [1,2,3], "target": [4,5,6], "up": [0,0,1], "fov": 40,
                 "height": 7, "aperture": 0.5, "focus_distance": 9},
      "image": {"width": 640, "height": 480},
      "render": {"spp": 16, "seed": 4294967295, "max_depth": 0, "channel_sampling": "throughput", "guiding": "none",
                 "clearance": false, "exposure": -1.5},
      "device": {"lanes": 1},
      "materials": {"wax": {"base_color": [0.1, 0.2, 0.3], "base_metalness": 0.4, "specular_weight": 0.5,
        "specular_roughness": 0.6, "specular_ior": 1.7, "emission_luminance": 8, "emission_color": 0.9,
        "subsurface_weight": 0.11, "subsurface_color": {"texture": "red.ppm", "scale": [2, 3], "offset": [4, 5]},
        "subsurface_radius": 0.12, "subsurface_radius_scale": [0.13, 0.14, 0.15],
        "subsurface_scatter_anisotropy": -0.16, "subsurface_bleed": 0.17, "subsurface_flight": "reciprocal",
        "subsurface_model": "better_dipole", "subsurface_inversion": "none", "subsurface_entry": "refracted",
        "subsurface_internal_reflection": true, "subsurface_max_depth": 256, "geometry_normal": {"texture": "red.ppm"}}},
      "objects": [{"box": {"min": [0,0,0], "max": [1,2,3]}, "material": "wax"}],
      "lights": [{"type": "environment", "radiance": [1,2,3], "visible": false},
                 {"type": "environment", "image": "red.ppm", "scale": 2, "rotate": 90},
                 {"type": "directional", "direction": [0,0,-2], "irradiance": 3},
                 {"type": "point", "position": [1,2,3], "intensity": [4,5,6]},
                 {"type": "rect", "center": [0,3,0], "u": [2,0,0], "v": [0,0,4], "radiance": 7, "visible": true}]
    })");
    EXPECT_EQ(s.camera.kind, CAMERA_ORTHOGRAPHIC);
    EXPECT_EQ(s.camera.position, Vec3(1, 2, 3));
    EXPECT_EQ(s.camera.target, Vec3(4, 5, 6));
    EXPECT_EQ(s.camera.up, Vec3(0, 0, 1));
    EXPECT_EQ(s.camera.fov, 40);
    EXPECT_EQ(s.camera.height, 7);
    EXPECT_EQ(s.camera.aperture, 0.5);
    EXPECT_EQ(s.camera.focus_distance, 9);
    EXPECT_EQ(s.image.width, 640);
    EXPECT_EQ(s.image.height, 480);
    EXPECT_EQ(s.render.spp, 16u);
    EXPECT_EQ(s.render.seed, 4294967295u);
    EXPECT_EQ(s.render.max_depth, 0u);
    EXPECT_EQ(s.render.channel_sampling, CHANNEL_THROUGHPUT);
    EXPECT_EQ(s.render.exposure, -1.5);
    EXPECT_EQ(s.lanes, 1);

    ASSERT_EQ(s.materials.size(), 1u);
    const scene::Material &m = s.materials[0];
    const auto value = [&m](Parameter p) { return m[p].value; };
    EXPECT_EQ(m.name, "wax");
    EXPECT_EQ(value(PARAMETER_base_color), Vec3(0.1, 0.2, 0.3));
    EXPECT_EQ(value(PARAMETER_base_metalness), Vec3::Constant(0.4));
    EXPECT_EQ(value(PARAMETER_specular_weight), Vec3::Constant(0.5));
    EXPECT_EQ(value(PARAMETER_specular_roughness), Vec3::Constant(0.6));
    EXPECT_EQ(value(PARAMETER_specular_ior), Vec3::Constant(1.7));
    EXPECT_EQ(value(PARAMETER_emission_luminance), Vec3::Constant(8));
    EXPECT_EQ(value(PARAMETER_emission_color), Vec3::Constant(0.9));
    EXPECT_EQ(value(PARAMETER_subsurface_weight), Vec3::Constant(0.11));
    EXPECT_EQ(value(PARAMETER_subsurface_radius), Vec3::Constant(0.12));
    EXPECT_EQ(value(PARAMETER_subsurface_radius_scale), Vec3(0.13, 0.14, 0.15));
    EXPECT_EQ(value(PARAMETER_subsurface_scatter_anisotropy), Vec3::Constant(-0.16));
    EXPECT_EQ(value(PARAMETER_subsurface_bleed), Vec3::Constant(0.17));
    EXPECT_EQ(m.flight, FLIGHT_RECIPROCAL);
    EXPECT_EQ(m.model, MODEL_BETTER_DIPOLE);
    EXPECT_EQ(m.inversion, INVERSION_NONE);
    EXPECT_EQ(m.entry, ENTRY_REFRACTED);
    EXPECT_TRUE(m.internal_reflection);
    EXPECT_EQ(m.max_depth, 256u);
    ASSERT_GE(m[PARAMETER_subsurface_color].texture, 0);
    const scene::Texture &texture = s.textures[m[PARAMETER_subsurface_color].texture];
    EXPECT_EQ(texture.scale, Vec2(2, 3));
    EXPECT_EQ(texture.offset, Vec2(4, 5));
    EXPECT_EQ(texture.channel, -1);
    EXPECT_GE(m[PARAMETER_geometry_normal].texture, 0);
    EXPECT_EQ(s.images.size(), 2u); // the colour is srgb, the normal linear

    ASSERT_EQ(s.lights.size(), 5u);
    EXPECT_EQ(s.lights[0].kind, LIGHT_ENVIRONMENT);
    EXPECT_EQ(s.lights[0].radiance, Vec3(1, 2, 3));
    EXPECT_FALSE(s.lights[0].visible);
    EXPECT_EQ(s.lights[1].kind, LIGHT_ENVIRONMENT_IMAGE);
    EXPECT_EQ(s.lights[1].radiance, Vec3(2, 2, 2));
    EXPECT_EQ(s.lights[1].rotate, 90);
    EXPECT_EQ(s.lights[1].pixels.size(), 3u);
    EXPECT_TRUE(s.lights[1].visible);
    EXPECT_EQ(s.lights[2].kind, LIGHT_DIRECTIONAL);
    EXPECT_EQ(s.lights[2].direction, Vec3(0, 0, -1));
    EXPECT_EQ(s.lights[2].radiance, Vec3(3, 3, 3));
    EXPECT_EQ(s.lights[3].kind, LIGHT_POINT);
    EXPECT_EQ(s.lights[3].position, Vec3(1, 2, 3));
    EXPECT_EQ(s.lights[3].radiance, Vec3(4, 5, 6));
    EXPECT_FALSE(s.lights[3].visible);
    EXPECT_EQ(s.lights[4].kind, LIGHT_RECT);
    EXPECT_EQ(s.lights[4].position, Vec3(0, 3, 0));
    EXPECT_EQ(s.lights[4].u, Vec3(2, 0, 0));
    EXPECT_EQ(s.lights[4].v, Vec3(0, 0, 4));
    EXPECT_EQ(s.lights[4].radiance, Vec3(7, 7, 7));
    EXPECT_TRUE(s.lights[4].visible);
}

TEST_F(JsonScene, DefaultsAreOpenPbrs) {
    const scene::Scene s =
        load_text(R"({"materials": {"m": {}}, "objects": [{"sphere": {"segments": 8}, "material": "m"}]})");
    const auto value = [&](Parameter p) { return s.materials[0][p].value; };
    EXPECT_EQ(value(PARAMETER_base_color), Vec3::Constant(0.8));
    EXPECT_EQ(value(PARAMETER_specular_weight), Vec3::Constant(1));
    EXPECT_EQ(value(PARAMETER_specular_roughness), Vec3::Constant(0.3));
    EXPECT_EQ(value(PARAMETER_specular_ior), Vec3::Constant(1.5));
    EXPECT_EQ(value(PARAMETER_subsurface_weight), Vec3::Constant(0));
    EXPECT_EQ(value(PARAMETER_subsurface_radius_scale), Vec3(1, 0.5, 0.25));
    EXPECT_EQ(value(PARAMETER_subsurface_bleed), Vec3::Constant(0));
    EXPECT_EQ(s.materials[0].flight, FLIGHT_RENEWAL);
    EXPECT_EQ(s.materials[0].model, MODEL_RANDOM_WALK);
    EXPECT_EQ(s.materials[0].inversion, INVERSION_TABLE);
    EXPECT_EQ(s.render.spp, 64u);
    EXPECT_EQ(s.render.channel_sampling, CHANNEL_HERO);
    ASSERT_EQ(s.lights.size(), 1u);
    EXPECT_EQ(s.lights[0].kind, LIGHT_ENVIRONMENT);
    EXPECT_EQ(s.lights[0].radiance, Vec3(1, 1, 1));
    EXPECT_TRUE(s.lights[0].visible);
}

TEST_F(JsonScene, NoLightsIsNotAnEmptyList) {
    EXPECT_TRUE(load_text("{" + one_sphere + R"(, "lights": []})").lights.empty());
}

TEST_F(JsonScene, ObjectsWithoutMaterialGetASkinOfTheirSize) {
    const scene::Scene s = load_text(R"({"objects": [{"sphere": {"radius": 1}}, {"sphere": {"radius": 100}}]})");
    ASSERT_EQ(s.materials.size(), 2u);
    const double small = s.materials[s.objects[0].material][PARAMETER_subsurface_radius].value.x();
    const double large = s.materials[s.objects[1].material][PARAMETER_subsurface_radius].value.x();
    EXPECT_NEAR(small, 0.02 * std::sqrt(12), 1e-9);
    EXPECT_NEAR(large / small, 100, 1e-9);
    EXPECT_EQ(s.materials[0][PARAMETER_subsurface_weight].value.x(), 1);
}

TEST_F(JsonScene, TheDefaultCameraSeesAllOfTheObjectAtAnyScaleAndShape) {
    for (const char *corner : {"[2, 7, 5]", "[9, 3, 5]"}) // tall, wide
        for (const double scale : {1e-6, 1.0, 1e6})
            for (const auto &[width, height] : {std::pair{100, 400}, std::pair{400, 100}}) {
                const scene::Scene s = load_text(fmt::format(
                    R"({{"image": {{"width": {}, "height": {}}}, "camera": {{"fov": 20}},
                    "objects": [{{"box": {{"min": [1, 2, 3], "max": {}}}, "transform": {{"scale": {}}}}}]}})",
                    width, height, corner, scale));
                const Vec3 back = (s.camera.position - s.camera.target).normalized();
                const Vec3 right = s.camera.up.cross(back).normalized(), up = back.cross(right);
                const double tan_y = std::tan(10 * 3.14159265358979 / 180);
                double largest = 0;
                for (const Vec3 &p : s.objects[0].mesh.positions) {
                    const Vec3 from = p - s.camera.position;
                    const double depth = -from.dot(back);
                    ASSERT_GT(depth, 0);
                    largest = std::max({largest, std::abs(from.dot(up)) / depth / tan_y,
                                        std::abs(from.dot(right)) / depth / tan_y * height / width});
                }
                EXPECT_LT(largest, 1);    // in the picture
                EXPECT_GT(largest, 0.75); // and filling it
                EXPECT_EQ(s.camera.fov, 20);
            }
}

TEST_F(JsonScene, TransformIsScaleThenRotateXyzThenTranslate) {
    const scene::Scene s = load_text(R"({"objects": [{"box": {"min": [0,0,0], "max": [1,1,1]},
        "transform": {"scale": [2, 3, 4], "rotate": [90, 0, 90], "translate": [10, 20, 30]}}]})");
    // The corner (1, 0, 0) -> (2, 0, 0) -> about x: the same -> about z: (0, 2, 0) -> moved.
    // The corner (0, 1, 0) -> (0, 3, 0) -> about x: (0, 0, 3) -> about z: the same -> moved.
    const auto has = [&](const Vec3 &corner) {
        for (const Vec3 &p : s.objects[0].mesh.positions)
            if ((p - corner).norm() < 1e-9) return true;
        return false;
    };
    EXPECT_TRUE(has({10, 22, 30}));
    EXPECT_TRUE(has({10, 20, 33}));
    EXPECT_TRUE(has({14, 20, 30})); // (0, 0, 4) -> (0, -4, 0) -> (4, 0, 0)
}

TEST_F(JsonScene, SmoothAddsOrRemovesNormals) {
    const scene::Scene s = load_text(R"({"objects": [{"box": {}}, {"box": {}, "smooth": true},
        {"sphere": {"segments": 8}}, {"sphere": {"segments": 8}, "smooth": false}]})");
    EXPECT_TRUE(s.objects[0].mesh.normals.empty());
    EXPECT_FALSE(s.objects[1].mesh.normals.empty());
    EXPECT_FALSE(s.objects[2].mesh.normals.empty());
    EXPECT_TRUE(s.objects[3].mesh.normals.empty());
}

TEST_F(JsonScene, AlbedoTakesThePlaceOfTheColour) {
    const scene::Scene s = load_text(R"({"materials": {"m": {"subsurface_albedo": [0.9, 0.8, 0.7]}},
                                         "objects": [{"sphere": {"segments": 8}, "material": "m"}]})");
    EXPECT_EQ(s.materials[0][PARAMETER_subsurface_color].value, Vec3(0.9, 0.8, 0.7));
    EXPECT_EQ(s.materials[0].inversion, INVERSION_NONE);
}

TEST_F(JsonScene, ATextureIsReadOncePerColourSpace) {
    put(folder / "red.ppm", red_pixel);
    const scene::Scene s = load_text(R"({"materials": {
        "a": {"base_color": {"texture": "red.ppm"}, "specular_roughness": {"texture": "red.ppm"}},
        "b": {"base_color": {"texture": "red.ppm"}, "subsurface_color": {"texture": "red.ppm", "colorspace": "linear"}}},
        "objects": [{"sphere": {"segments": 8}, "material": "a"}]})");
    EXPECT_EQ(s.images.size(), 2u);
    EXPECT_EQ(s.textures.size(), 4u);
    EXPECT_EQ(s.textures[s.materials[0][PARAMETER_specular_roughness].texture].channel, 0); // a number: the first one
}

TEST_F(JsonScene, EqualAnisotropiesAreOne) {
    const scene::Scene s = load_text(R"({"materials": {"m": {"subsurface_scatter_anisotropy": [0.5, 0.5, 0.5]}},
                                         "objects": [{"sphere": {"segments": 8}, "material": "m"}]})");
    EXPECT_EQ(s.materials[0][PARAMETER_subsurface_scatter_anisotropy].value, Vec3::Constant(0.5));
}

TEST_F(JsonScene, FilesAreFoundInNacreAssets) {
    std::filesystem::create_directories(folder / "assets");
    put(folder / "assets" / "t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string json = R"({"objects": [{"mesh": "t.obj"}]})";
    setenv("NACRE_ASSETS", ("/nowhere:" + (folder / "assets").string()).c_str(), 1);
    EXPECT_EQ(load_text(json).objects[0].mesh.triangles.size(), 1u);
    setenv("NACRE_ASSETS", "/nowhere", 1);
    const std::string message = error_of("scene.json");
    unsetenv("NACRE_ASSETS");
    EXPECT_NE(message.find("/nowhere"), std::string::npos) << message;
    EXPECT_NE(message.find(folder.string()), std::string::npos) << message;
}

TEST_F(JsonScene, SetChangesWhatTheFileSays) {
    const std::string json = R"({"materials": {"skin.001": {"subsurface_radius": 1}},
        "objects": [{"sphere": {"segments": 8}, "material": "skin.001"}, {"box": {}}], "image": {"width": 10}})";
    const scene::Scene s = load_text(json, {{"materials.skin.001.subsurface_radius", "0.25"},
                                            {"render.spp", "5"},
                                            {"render.channel_sampling", "single"}, // a bare word is a string
                                            {"objects.1.box.max", "[5, 5, 5]"},
                                            {"lights.0.radiance", "7"},
                                            {"image.width", "20"}});
    EXPECT_EQ(s.materials[0][PARAMETER_subsurface_radius].value.x(), 0.25);
    EXPECT_EQ(s.render.spp, 5u);
    EXPECT_EQ(s.render.channel_sampling, CHANNEL_SINGLE);
    EXPECT_EQ(s.objects[1].mesh.positions.back().maxCoeff(), 5);
    EXPECT_EQ(s.lights[0].radiance, Vec3(7, 7, 7));
    EXPECT_EQ(s.image.width, 20);
}

TEST_F(JsonScene, WrongSetsNameTheOption) {
    put(folder / "scene.json",
        R"({"materials": {"skin": {}}, "objects": [{"sphere": {"segments": 8}, "material": "skin"}]})");
    const auto error = [&](const std::string &path, const std::string &value) {
        return error_of("scene.json", {{path, value}});
    };
    EXPECT_EQ(error("render.sp", "1"), "--set: render.sp: unknown field, did you mean 'spp'?");
    EXPECT_EQ(error("rendr.spp", "1"), "--set: rendr: unknown field, did you mean 'render'?");
    EXPECT_EQ(error("materials.skim.base_color", "1"),
              "--set: materials.skim: there is no such material, did you mean 'skin'?");
    EXPECT_EQ(error("objects.3.material", "skin"), "--set: objects: there is no element '3', only 0 to 0");
    EXPECT_EQ(error("image.width", "0"), "--set: image.width: 0 is out of range, must be a whole number in [1, 65536]");
    EXPECT_EQ(error("objects.0.sphere.radius.x", "0").substr(0, 6), "--set:");
    EXPECT_EQ(error("", "0").substr(0, 6), "--set:");
    EXPECT_EQ(error("a..b", "0").substr(0, 6), "--set:");
}

} // namespace
} // namespace nacre
