#include "host/mesh_files.h"
#include "host/scene_folder.h"
#include "scene/topology.h"

namespace nacre {
namespace {

using namespace shared;
class Obj : public SceneFolder {};

TEST_F(Obj, ABareMeshGetsCameraLightAndSkinOfItsSize) {
    for (const double scale : {1.0, 1000.0}) {
        put(folder / "m.obj", tetrahedron_obj);
        const scene::Scene s = load("m.obj", {{"objects.0.transform.scale", std::to_string(scale)}});
        const double diagonal = scale * std::sqrt(14);
        ASSERT_EQ(s.objects.size(), 1u);
        EXPECT_EQ(s.objects[0].mesh.triangles.size(), 4u);
        const scene::Material &skin = s.materials.at(s.objects[0].material);
        EXPECT_EQ(skin.name, "skin");
        EXPECT_EQ(skin[PARAMETER_subsurface_weight].value.x(), 1);
        EXPECT_NEAR(skin[PARAMETER_subsurface_radius].value.x() / diagonal, 0.02, 1e-9);
        EXPECT_GT(s.camera.position.z(), s.camera.target.z()); // in front
        EXPECT_GT(s.camera.position.y(), s.camera.target.y()); // slightly above
        ASSERT_EQ(s.lights.size(), 3u);
        EXPECT_EQ(s.lights[0].kind, LIGHT_ENVIRONMENT);
        const Vec3 centre = Vec3(0.5, 1, 1.5) * scale;
        for (int i = 1; i < 3; ++i) { // both rects face the object, from outside of it, and scale with it
            const scene::Light &light = s.lights[i];
            const Vec3 away = light.position - centre;
            EXPECT_LT((light.u.cross(light.v).normalized() + away.normalized()).norm(), 1e-9);
            EXPECT_NEAR(away.norm() / diagonal, 1.5, 1e-9);
            EXPECT_NEAR(light.u.norm() / diagonal, 0.8, 1e-9);
        }
        EXPECT_GT((s.lights[1].position - centre).z(), 0); // the key in front, to the left, above
        EXPECT_LT((s.lights[1].position - centre).x(), 0);
        EXPECT_GT((s.lights[1].position - centre).y(), 0);
        EXPECT_LT((s.lights[2].position - centre).z(), 0); // the other one behind
    }
}

TEST_F(Obj, OverridesReachTheDefaultsOfABareMesh) {
    put(folder / "m.obj", tetrahedron_obj);
    const scene::Scene s = load("m.obj", {{"materials.skin.subsurface_bleed", "0.5"},
                                          {"lights.1.radiance", "3"},
                                          {"camera.fov", "20"},
                                          {"image.width", "77"},
                                          {"objects.0.smooth", "true"}});
    EXPECT_EQ(s.materials[0][PARAMETER_subsurface_bleed].value.x(), 0.5);
    EXPECT_EQ(s.lights[1].radiance, Vec3(3, 3, 3));
    EXPECT_EQ(s.camera.fov, 20);
    EXPECT_EQ(s.image.width, 77);
    EXPECT_EQ(s.objects[0].mesh.normals.size(), 4u);
    EXPECT_NE(error_of("m.obj", {{"materials.skni.subsurface_bleed", "0"}}).find("did you mean 'skin'"),
              std::string::npos);
}

TEST_F(Obj, PositionsNormalsAndUvsAreOneIndex) {
    put(folder / "m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\nvn 0 1 0\n"
                          "usemtl bark\nf 1/1/1 2/2/1 3/3/1 4/4/1\nf -4/1/2 -3/2/2 -2/3/2\n");
    const scene::Scene s = load("m.obj");
    ASSERT_EQ(s.warnings.size(), 1u);
    EXPECT_NE(s.warnings[0].find("materials are not used"), std::string::npos);
    const scene::Mesh &mesh = s.objects[0].mesh;
    EXPECT_EQ(mesh.triangles.size(), 3u);
    EXPECT_EQ(mesh.positions.size(), 7u); // four, and three again with another normal
    ASSERT_EQ(mesh.uvs.size(), 7u);
    ASSERT_EQ(mesh.normals.size(), 7u);
    EXPECT_EQ(mesh.uvs[2], Vec2f(1, 1));
    EXPECT_EQ(mesh.normals[6], Vec3f(0, 1, 0));
}

TEST_F(Obj, SomeNormalsAreNoNormals) {
    put(folder / "m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\nf 3 2 1\n");
    const scene::Scene s = load("m.obj");
    EXPECT_TRUE(s.objects[0].mesh.normals.empty());
    EXPECT_EQ(s.warnings.size(), 1u);
}

TEST_F(Obj, ZeroNormalsAreComputed) {
    put(folder / "m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nvn 0 0 0\nf 1//1 2//1 3//1\n");
    const scene::Scene s = load("m.obj");
    ASSERT_EQ(s.objects[0].mesh.normals.size(), 3u);
    EXPECT_EQ(s.objects[0].mesh.normals[0], Vec3f(0, 0, 1));
    EXPECT_EQ(s.warnings.size(), 1u);
}

TEST_F(Obj, SmallConcavePolygonsKeepTheirShape) {
    // tinyobj's own cutting measures in absolute units and fails below 1e-4.
    put(folder / "m.obj", "v 1e-6 -1e-6 0\nv 0 2e-6 0\nv -1e-6 -1e-6 0\nv -1e-7 0 0\nv 1e-7 0 0\nf 1 2 3 4 5\n");
    const scene::Mesh mesh = load("m.obj").objects[0].mesh;
    double area = 0;
    for (const auto &[a, b, c] : mesh.triangles)
        area += (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]).norm() / 2;
    EXPECT_EQ(mesh.triangles.size(), 3u);
    EXPECT_NEAR(area / 1e-12, 1.9, 1e-6);
}

TEST_F(Obj, BadFilesAreErrors) {
    const struct {
        std::string text, fragment;
    } cases[] = {
        {"", "has no triangles"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\n", "has no triangles"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "a face names vertex 4, there are 3"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n", "a face names vertex 0"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//1 2//1 3//1\n", "a face names normal 1, there are 0"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/2 2/2 3/2\n", "a face names uv 2, there are 0"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "is not a valid OBJ file"},
        {"v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "none of its 1 triangles has an area"},
        {"v 0 0 0\nv 1e39 0 0\nv 0 1 0\nf 1 2 3\n", "vertex 1 is at (inf"},
    };
    for (const auto &[text, fragment] : cases) {
        put(folder / "m.obj", text);
        const std::string message = error_of("m.obj");
        EXPECT_NE(message.find(fragment), std::string::npos) << "'" << message << "' lacks '" << fragment << "'";
        EXPECT_TRUE(message.starts_with((folder / "m.obj").string())) << message;
    }
    std::string face = "f";
    for (int i = 0; i < 300; ++i) face += " " + std::to_string(i % 3 + 1);
    put(folder / "m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + face + "\n");
    EXPECT_NE(error_of("m.obj").find("more than 255 vertices"), std::string::npos);
}

} // namespace
} // namespace nacre
