#include "host/gltf_builder.h"
#include "host/scene_folder.h"

namespace nacre {
namespace {

using namespace shared;
using io::Json;

class GltfMaterials : public SceneFolder {
  protected:
    // A scene of one object with this material; texture 0 is a red pixel beside the file.
    void build(const char *material) {
        GltfBuilder builder;
        builder.json["materials"] = Json::array({Json::parse(material)});
        builder.json["images"] = {{{"uri", "red.ppm"}}};
        builder.json["textures"] = {{{"source", 0}}, {{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}}};
        builder.add_node({{"mesh", builder.add_tetrahedron(0)}});
        put(folder / "red.ppm", red_pixel);
        put(folder / "s.glb", builder.glb());
    }

    scene::Scene load_material(const char *material) {
        build(material);
        return load("s.glb");
    }

    void expect_error(const char *material, const std::string &fragment) {
        build(material);
        const std::string message = error_of("s.glb");
        EXPECT_NE(message.find(fragment), std::string::npos) << "'" << message << "' lacks '" << fragment << "'";
    }
};

TEST_F(GltfMaterials, MetallicRoughness) {
    const scene::Scene s = load_material(R"({"name": "m",
        "pbrMetallicRoughness": {"baseColorFactor": [0.1, 0.2, 0.3, 1], "metallicFactor": 0.4, "roughnessFactor": 0.5},
        "extensions": {"KHR_materials_ior": {"ior": 1.33}, "KHR_materials_specular": {"specularFactor": 0.7},
                       "KHR_materials_emissive_strength": {"emissiveStrength": 6}}, "emissiveFactor": [1, 0.5, 0.25]})");
    const scene::Material &m = s.materials.at(0);
    EXPECT_EQ(m.name, "m");
    EXPECT_EQ(m[PARAMETER_base_color].value, Vec3(0.1, 0.2, 0.3));
    EXPECT_EQ(m[PARAMETER_base_metalness].value.x(), 0.4);
    EXPECT_EQ(m[PARAMETER_specular_roughness].value.x(), 0.5);
    EXPECT_EQ(m[PARAMETER_specular_ior].value.x(), 1.33);
    EXPECT_EQ(m[PARAMETER_specular_weight].value.x(), 0.7);
    EXPECT_EQ(m[PARAMETER_emission_luminance].value.x(), 6);
    EXPECT_EQ(m[PARAMETER_emission_color].value, Vec3(1, 0.5, 0.25));
    EXPECT_EQ(m[PARAMETER_subsurface_weight].value.x(), 0);
    EXPECT_TRUE(s.lights.empty()); // it is lit by what emits
    EXPECT_TRUE(s.warnings.empty());
}

TEST_F(GltfMaterials, TexturesAndTheirChannels) {
    const scene::Scene s = load_material(R"({
        "pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "extensions": {"KHR_texture_transform":
            {"scale": [2, 3], "offset": [0.25, 0.5]}}}, "metallicRoughnessTexture": {"index": 0}},
        "normalTexture": {"index": 0}})");
    const scene::Material &m = s.materials.at(0);
    const auto texture = [&](Parameter p) { return s.textures.at(m[p].texture); };
    EXPECT_EQ(texture(PARAMETER_base_color).channel, -1);
    EXPECT_EQ(texture(PARAMETER_specular_roughness).channel, 1);
    EXPECT_EQ(texture(PARAMETER_base_metalness).channel, 2);
    EXPECT_EQ(texture(PARAMETER_geometry_normal).channel, -1);
    EXPECT_EQ(s.images.size(), 2u); // srgb and linear
    // glTF: v' = 3 v + .5, v down. Ours: 1 - (3 (1 - v) + .5) = 3 v - 2.5.
    EXPECT_EQ(texture(PARAMETER_base_color).scale, Vec2(2, 3));
    EXPECT_EQ(texture(PARAMETER_base_color).offset, Vec2(0.25, -2.5));
    EXPECT_TRUE(s.warnings.empty());
}

TEST_F(GltfMaterials, AGreyPictureHasOneChannelForAll) {
    build(R"({"pbrMetallicRoughness": {"metallicRoughnessTexture": {"index": 0}}})");
    put(folder / "red.ppm", "P2\n1 1\n255\n128\n");
    const scene::Scene s = load("s.glb");
    ASSERT_EQ(s.images.at(0).channels, 1u);
    for (const scene::Texture &texture : s.textures) EXPECT_EQ(texture.channel, 0);
}

TEST_F(GltfMaterials, FactorsBesideTexturesAreNamed) {
    const scene::Scene s = load_material(R"({"pbrMetallicRoughness":
        {"baseColorTexture": {"index": 0}, "baseColorFactor": [0.5, 1, 1, 1], "metallicFactor": 0}})");
    ASSERT_EQ(s.warnings.size(), 1u);
    EXPECT_NE(s.warnings[0].find("baseColorTexture"), std::string::npos);
}

TEST_F(GltfMaterials, VolumeScatterOfTheSkull) { // of KhronosGroup/glTF-Sample-Assets, ScatteringSkull
    const scene::Scene s = load_material(R"({"pbrMetallicRoughness": {"metallicFactor": 0.0, "roughnessFactor": 0.53},
        "extensions": {"KHR_materials_transmission": {"transmissionFactor": 1},
          "KHR_materials_volume": {"attenuationColor": [0.36788, 0.48573, 0.39641],
             "attenuationDistance": 0.016891848, "thicknessFactor": 1},
          "KHR_materials_volume_scatter": {"multiscatterColor": [0.16827, 0.52712, 0.59063], "scatterAnisotropy": 0.3},
          "KHR_materials_ior": {"ior": 1.38}}})");
    const scene::Material &m = s.materials.at(0);
    EXPECT_EQ(m[PARAMETER_subsurface_weight].value.x(), 1);
    EXPECT_EQ(m[PARAMETER_subsurface_color].value, Vec3(0.16827, 0.52712, 0.59063));
    EXPECT_EQ(m[PARAMETER_subsurface_scatter_anisotropy].value.x(), 0.3);
    EXPECT_EQ(m.inversion, INVERSION_VAN_DE_HULST);
    const Vec3 color(0.36788, 0.48573, 0.39641);
    for (int c = 0; c < 3; ++c) {
        const double path = m[PARAMETER_subsurface_radius].value.x() * m[PARAMETER_subsurface_radius_scale].value[c];
        EXPECT_NEAR(std::exp(-0.016891848 / path), color[c], 1e-9); // what goes through attenuationDistance
    }
    EXPECT_TRUE(s.warnings.empty());
}

TEST_F(GltfMaterials, ScatterScalesTheColourByItsStrength) {
    const scene::Scene s = load_material(R"({"pbrMetallicRoughness": {"metallicFactor": 0},
        "extensions": {"KHR_materials_volume": {"thicknessFactor": 1, "attenuationDistance": 0.5,
             "attenuationColor": [0.5, 0.5, 1]}, "KHR_materials_transmission": {"transmissionFactor": 0.75},
          "KHR_materials_scatter": {"scatterStrengthFactor": 0.5, "multiscatterColorFactor": [0.8, 0.8, 0.1]}}})");
    const scene::Material &m = s.materials.at(0);
    EXPECT_EQ(m[PARAMETER_subsurface_weight].value.x(), 0.75);
    EXPECT_LT((m[PARAMETER_subsurface_color].value - Vec3(0.4, 0.4, 0.05)).norm(), 1e-12);
    const double longest = m[PARAMETER_subsurface_radius].value.x(); // blue: not attenuated, so nearly clear
    EXPECT_NEAR(m[PARAMETER_subsurface_radius_scale].value.x() * longest, 0.5 / std::log(2), 1e-9);
    EXPECT_NEAR(longest, 1e4 * 0.5 / std::log(2), 1e-6);
}

TEST_F(GltfMaterials, ScatterWithoutAttenuationTakesTheObjectsSize) { // as in ScatterStrength of the sample assets
    const scene::Scene s = load_material(R"({"extensions": {"KHR_materials_volume": {"thicknessFactor": 1},
        "KHR_materials_transmission": {"transmissionFactor": 1},
        "KHR_materials_scatter": {"scatterStrengthFactor": 1, "multiscatterColorFactor": [0.8, 0.8, 0.1]}}})");
    EXPECT_NEAR(s.materials.at(0)[PARAMETER_subsurface_radius].value.x(), 0.02 * std::sqrt(14), 1e-6);
    ASSERT_EQ(s.warnings.size(), 1u);
    EXPECT_NE(s.warnings[0].find("no attenuation"), std::string::npos);
}

TEST_F(GltfMaterials, TransmissionAloneIsNamed) {
    const scene::Scene s =
        load_material(R"({"extensions": {"KHR_materials_transmission": {"transmissionFactor": 1}}})");
    EXPECT_EQ(s.materials.at(0)[PARAMETER_subsurface_weight].value.x(), 0);
    ASSERT_EQ(s.warnings.size(), 1u);
    EXPECT_NE(s.warnings[0].find("transmission without scattering"), std::string::npos);
}

TEST_F(GltfMaterials, ExtrasOfNacreWin) {
    const scene::Scene s = load_material(R"({"pbrMetallicRoughness": {"roughnessFactor": 0.5},
        "extras": {"nacre": {"subsurface_weight": 1, "subsurface_bleed": 0.5, "subsurface_flight": "reciprocal",
        "subsurface_entry": "refracted", "subsurface_internal_reflection": true, "subsurface_model": "dipole"}}})");
    const scene::Material &m = s.materials.at(0);
    EXPECT_EQ(m[PARAMETER_subsurface_weight].value.x(), 1);
    EXPECT_EQ(m[PARAMETER_subsurface_bleed].value.x(), 0.5);
    EXPECT_EQ(m[PARAMETER_specular_roughness].value.x(), 0.5);
    EXPECT_EQ(m.flight, FLIGHT_RECIPROCAL);
    EXPECT_EQ(m.entry, ENTRY_REFRACTED);
    EXPECT_TRUE(m.internal_reflection);
    EXPECT_EQ(m.model, MODEL_DIPOLE);
}

TEST_F(GltfMaterials, BadOnesAreErrors) {
    expect_error(R"({"extras": {"nacre": {"subsurface_bled": 1}}})", "extras.nacre.subsurface_bled: unknown field");
    expect_error(R"({"pbrMetallicRoughness": {"roughnessFactor": 2}})", "materials.0.specular_roughness: 2 is out of");
    expect_error(R"({"pbrMetallicRoughness": {"roughnessFactor": "r"}})", "roughnessFactor: expected a number");
    expect_error(R"({"pbrMetallicRoughness": {"baseColorFactor": [1, "g", 1]}})", "baseColorFactor: expected three");
    expect_error(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 5}}})", "textures: there is no element 5");
    expect_error(R"({"normalTexture": {"index": 1}})", "normalTexture: its texture has no image");
    expect_error(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 1e30}}})", "is not an index");
    expect_error(R"({"pbrMetallicRoughness": {"baseColorTexture": {}}})", "textures: there is no element -1");
    expect_error(R"({"extensions": {"KHR_materials_ior": {"ior": 0.5}}})", "specular_ior: 0.5 is out of range");
    expect_error(R"({"extensions": {"KHR_materials_scatter": {"scatterAnisotropy": 1}}})", "anisotropy: 1 is out of");
}

} // namespace
} // namespace nacre
