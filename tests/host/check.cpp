#include "scene/check.h"
#include "scene/topology.h"
#include <gtest/gtest.h>

namespace nacre::scene {
namespace {

// A scene in which nothing is to be found, to spoil in one way each.
Scene good_scene() {
    Scene scene;
    scene.file = "scene.json";
    scene.materials.emplace_back().name = "skin";
    scene.materials[0][shared::PARAMETER_subsurface_weight].value.setConstant(1);
    scene.materials[0][shared::PARAMETER_subsurface_radius].value.setConstant(0.05);
    scene.objects.push_back({"ball", make_sphere({0, 0, 0}, 1, 16), 0, 0});
    scene.lights.emplace_back();
    return scene;
}

// The only finding, of `subject`, says `fragment`.
void expect_finding(const Scene &scene, const std::string &subject, const std::string &fragment) {
    const std::vector<Finding> findings = check(scene);
    ASSERT_EQ(findings.size(), 1u) << fragment;
    EXPECT_EQ(findings[0].subject, subject);
    EXPECT_NE(findings[0].text.find(fragment), std::string::npos) << findings[0].text;
}

TEST(Check, FindsNothingInAGoodScene) {
    for (const Finding &finding : check(good_scene())) ADD_FAILURE() << finding.subject << ": " << finding.text;
}

TEST(Check, NamesColorsOutOfReach) {
    const auto spoilt = [](const auto &spoil) {
        Scene scene = good_scene();
        spoil(scene, scene.materials[0]);
        return scene;
    };
    expect_finding(spoilt([](Scene &, Material &m) { m.max_depth = 256; }), "ball", "walks end after 256 scatters");
    expect_finding(spoilt([](Scene &, Material &m) { m.internal_reflection = true; }), "ball", "turned back");
    expect_finding(spoilt([](Scene &, Material &m) { m.entry = shared::ENTRY_REFRACTED; }), "ball", "refracted");
    expect_finding(
        spoilt([](Scene &, Material &m) { m[shared::PARAMETER_subsurface_scatter_anisotropy].value.setConstant(.99); }),
        "ball", "from -0.95 to 0.98");
    expect_finding(spoilt([](Scene &, Material &m) { m[shared::PARAMETER_subsurface_bleed].value.setConstant(5); }),
                   "ball", "bleed up to 4");
    for (const double color : {.95, .99}) // an albedo that is some float below 1, and one that is 1 as a float
        expect_finding(spoilt([color](Scene &, Material &m) {
                           m.flight = shared::FLIGHT_RECIPROCAL;
                           m[shared::PARAMETER_subsurface_bleed].value.setConstant(4);
                           m[shared::PARAMETER_subsurface_color].value = {color, .5, .5};
                       }),
                       "ball", fmt::format("a colour of {} takes an albedo nearer to 1 than a float tells", color));
    expect_finding(spoilt([](Scene &scene, Material &m) {
                       m[shared::PARAMETER_subsurface_color].texture = 0;
                       scene.textures.push_back({});
                       Image &two = scene.images.emplace_back();
                       two.width = two.height = two.channels = 1;
                       two.halves = {0x4000};
                       scene.objects[0].mesh.uvs.resize(scene.objects[0].mesh.positions.size());
                   }),
                   "ball", "reaches 2");
}

TEST(Check, KnowsWhichChannelSamplingSuits) {
    for (const auto sampling :
         {shared::CHANNEL_SINGLE, shared::CHANNEL_ALBEDO, shared::CHANNEL_THROUGHPUT, shared::CHANNEL_HERO}) {
        Scene scene = good_scene();
        scene.render.channel_sampling = sampling;
        scene.materials[0][shared::PARAMETER_subsurface_radius_scale].value.setConstant(1);
        EXPECT_TRUE(check(scene).empty()) << "grey";
        scene.materials[0][shared::PARAMETER_subsurface_radius_scale].value = {1, .5, .25};
        if (sampling == shared::CHANNEL_SINGLE || sampling == shared::CHANNEL_ALBEDO)
            expect_finding(scene, "ball", "take hero");
        else
            EXPECT_TRUE(check(scene).empty()) << sampling;
    }
}

TEST(Check, CountsOpenEdges) {
    Scene scene = good_scene();
    scene.objects[0].mesh.triangles.pop_back();
    expect_finding(scene, "ball", "3 open edges");
}

TEST(Check, CountsNonManifoldEdges) {
    Scene scene = good_scene();
    Mesh &mesh = scene.objects[0].mesh;
    mesh = make_box({0, 0, 0}, {1, 1, 1});
    Mesh second = make_box({1, 1, 0}, {2, 2, 1}); // touches along one edge
    for (auto &[a, b, c] : second.triangles) a += 24, b += 24, c += 24;
    mesh.positions.insert(mesh.positions.end(), second.positions.begin(), second.positions.end());
    mesh.triangles.insert(mesh.triangles.end(), second.triangles.begin(), second.triangles.end());
    mesh.uvs.clear();
    expect_finding(scene, "ball", "1 edges have more than two triangles");
}

TEST(Check, FindsInconsistentWinding) {
    Scene scene = good_scene();
    std::swap(scene.objects[0].mesh.triangles[40][0], scene.objects[0].mesh.triangles[40][1]);
    scene.objects[0].mesh.normals.clear();
    expect_finding(scene, "ball", "3 edges lie between triangles of opposite winding");
}

TEST(Check, FindsShellsTurnedInsideOut) {
    Scene scene = good_scene();
    for (auto &triangle : scene.objects[0].mesh.triangles) std::swap(triangle[0], triangle[1]);
    scene.objects[0].mesh.normals.clear();
    expect_finding(scene, "ball", "inside out: 1 of 1 shells (224 triangles)");
}

TEST(Check, ACavityIsNotInsideOut) {
    Scene scene = good_scene();
    Mesh &mesh = scene.objects[0].mesh;
    Mesh cavity = make_sphere({0.1, 0, 0}, 0.5, 16);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const auto &[a, b, c] : cavity.triangles) mesh.triangles.push_back({b + first, a + first, c + first});
    mesh.positions.insert(mesh.positions.end(), cavity.positions.begin(), cavity.positions.end());
    mesh.normals.clear();
    mesh.uvs.clear();
    ASSERT_EQ(find_topology(mesh).shells.size(), 2u);
    for (const Finding &finding : check(scene)) ADD_FAILURE() << finding.text;
}

TEST(Check, FindsNormalsOnTheWrongSide) {
    Scene scene = good_scene();
    scene.objects[0].mesh.normals[40] *= -1;
    expect_finding(scene, "ball", "triangles have a vertex normal on their other side");
}

TEST(Check, RepeatsWhatWasDroppedAndNotUsed) {
    Scene dropped = good_scene();
    dropped.objects[0].degenerate = 7;
    expect_finding(dropped, "ball", "7 triangles without area");
    Scene warned = good_scene();
    warned.warnings.push_back("head.glb: animations are not used");
    expect_finding(warned, "scene.json", "head.glb: animations");
}

TEST(Check, ComparesTheMeanFreePathWithTheSize) {
    Scene clear = good_scene();
    clear.materials[0][shared::PARAMETER_subsurface_radius].value.setConstant(2);
    expect_finding(clear, "ball", "looks transparent; did you mean subsurface_radius = 0.04?");
    Scene dense = good_scene(); // the blue path is a quarter of the radius
    dense.materials[0][shared::PARAMETER_subsurface_radius].value.setConstant(1e-4);
    dense.materials[0][shared::PARAMETER_subsurface_radius_scale].value = Vec3(1, 1, 0.2);
    expect_finding(dense, "ball", "looks like paint; did you mean subsurface_radius = 0.04?");
    clear.materials[0][shared::PARAMETER_subsurface_weight].value.setZero(); // not used, so not wrong
    EXPECT_TRUE(check(clear).empty());
}

// The second body takes the scene's size far beyond that of the first.
TEST(Check, FindsFreePathsBelowTheSceneRounding) {
    Scene scene = good_scene();
    scene.objects.push_back({"far", make_sphere({1e5, 0, 0}, 1, 16), 1, 0});
    scene.materials.emplace_back().name = "matt";
    expect_finding(scene, "ball", "material 'skin': the mean free path 0.0125 is less than 3e-06 of the scene's size");
    scene.objects[1].mesh = make_sphere({1e3, 0, 0}, 1, 16);
    EXPECT_TRUE(check(scene).empty());
}

TEST(Check, CountsSlivers) {
    Scene scene = good_scene();
    scene.objects[0].mesh = make_box({-1, -1, -1}, {1, 1, -1 + 1.9e-3});
    scene.materials[0][shared::PARAMETER_subsurface_radius].value.setConstant(1e-3);
    expect_finding(scene, "ball", "8 of 12 triangles are more than 1000 times as long as wide");
    scene.materials[0][shared::PARAMETER_subsurface_weight].value.setZero(); // a surface minds no sliver
    EXPECT_TRUE(check(scene).empty());
}

TEST(Check, TexturesNeedUvs) {
    Scene scene = good_scene();
    scene.materials[0][shared::PARAMETER_base_color].texture = 0;
    EXPECT_TRUE(check(scene).empty());
    scene.objects[0].mesh.uvs.clear();
    expect_finding(scene, "ball", "has textures, the mesh has no uvs");
}

TEST(Check, FindsDarkness) {
    Scene scene = good_scene();
    scene.lights[0].radiance.setZero();
    expect_finding(scene, "scene.json", "has no light");
    scene.lights.clear();
    expect_finding(scene, "scene.json", "has no light");
    scene.materials[0][shared::PARAMETER_emission_luminance].value.setConstant(1);
    EXPECT_TRUE(check(scene).empty());
}

TEST(Check, FindsWhatADiffusionModelDoesNotKnow) {
    Scene scene = good_scene();
    scene.materials[0].model = shared::MODEL_BURLEY;
    EXPECT_TRUE(check(scene).empty());
    const Scene good = scene;
    scene.materials[0][shared::PARAMETER_subsurface_bleed].value.setConstant(.5);
    expect_finding(scene, "ball", "material 'skin': subsurface_bleed is of the random walk alone");
    scene = good;
    scene.materials[0].entry = shared::ENTRY_UNIFORM;
    expect_finding(scene, "ball", "subsurface_entry is of the random walk alone");
    scene = good;
    scene.materials[0].max_depth = 256;
    expect_finding(scene, "ball", "subsurface_max_depth is of the random walk alone");
}

} // namespace
} // namespace nacre::scene
