#include "host/mesh_files.h"
#include "host/scene_folder.h"
#include "io/mesh_file.h"
#include "scene/topology.h"

namespace nacre {
namespace {

class Ply : public SceneFolder {
  protected:
    scene::Mesh read(const std::string &bytes) {
        put(folder / "m.ply", bytes);
        return io::load_ply(folder / "m.ply");
    }

    // The error of a PLY file with this header (between "ply" and "end_header") and body.
    std::string error(const std::string &header, const std::string &body) {
        put(folder / "m.ply", "ply\n" + header + "end_header\n" + body);
        return error_of("m.ply");
    }
};

const std::string vertex_xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string face_list = "element face 1\nproperty list uchar int vertex_indices\n";

TEST_F(Ply, AllFormatsReadTheSame) {
    for (const char *format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
        const scene::Mesh mesh = read(tetrahedron_ply(format));
        ASSERT_EQ(mesh.positions.size(), 4u) << format;
        EXPECT_EQ(mesh.positions[1], Vec3(1, 0, 0));
        EXPECT_EQ(mesh.positions[2], Vec3(0, 2, 0));
        EXPECT_EQ(mesh.positions[3], Vec3(0, 0, 3));
        const scene::Topology topology = scene::find_topology(mesh);
        ASSERT_EQ(topology.shells.size(), 1u);
        EXPECT_TRUE(topology.shells[0].closed);
        EXPECT_NEAR(topology.shells[0].volume, 1, 1e-12);
    }
}

TEST_F(Ply, NormalsUvsPolygonsAndOtherElements) {
    const scene::Mesh mesh = read("ply\r\nformat ascii 1.0\nobj_info x\nelement camera 1\nproperty float fov\n"
                                  "property list uchar float k\nelement vertex 5\n" +
                                  vertex_xyz +
                                  "property float nx\nproperty float ny\nproperty float nz\nproperty float s\n"
                                  "property float t\nelement face 1\nproperty uchar flags\n"
                                  "property list uint8 uint vertex_index\nend_header\n35 2 1 2\n"
                                  "0 0 0 0 0 1 0 0\n1 0 0 0 0 1 1 0\n1 1 0 0 0 1 1 1\n0 1 0 0 0 1 .25 .75\n"
                                  "-1 .5 0 0 0 1 0 0\n7 5 0 1 2 3 4\n");
    ASSERT_EQ(mesh.triangles.size(), 3u);
    ASSERT_EQ(mesh.normals.size(), 5u);
    ASSERT_EQ(mesh.uvs.size(), 5u);
    EXPECT_EQ(mesh.normals[4], Vec3f(0, 0, 1));
    EXPECT_EQ(mesh.uvs[3], Vec2f(0.25f, 0.75f));
    double area = 0;
    for (const auto &[a, b, c] : mesh.triangles)
        area += (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]).z() / 2;
    EXPECT_NEAR(area, 1.5, 1e-12);
}

TEST_F(Ply, ConcaveQuadsKeepTheirShape) {
    // An arrow head: the diagonal from corner 0 would lie outside.
    const scene::Mesh mesh = read("ply\nformat ascii 1.0\nelement vertex 4\n" + vertex_xyz + face_list +
                                  "end_header\n1 -1 0\n0 2 0\n-1 -1 0\n0 0 0\n4 0 1 2 3\n");
    ASSERT_EQ(mesh.triangles.size(), 2u);
    for (const auto &[a, b, c] : mesh.triangles)
        EXPECT_GT((mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]).z(), 0);
}

TEST_F(Ply, BadFilesAreErrors) {
    const std::string ascii = "format ascii 1.0\n", vertex3 = "element vertex 3\n" + vertex_xyz;
    const std::string good = ascii + vertex3 + face_list, corners = "0 0 0\n1 0 0\n0 1 0\n";
    ASSERT_EQ(error(good, corners + "3 0 1 2\n"), "");
    const struct {
        std::string header, body, fragment;
    } cases[] = {
        {good, corners + "3 0 1 3\n", "face 0 names vertex 3, there are 3"},
        {good, corners + "3 0 1 -1\n", "face 0 names vertex -1"},
        {good, corners + "3 0 1 0.5\n", "face 0 names vertex 0.5"},
        {good, corners + "3 0 1\n", "ends before its last element"},
        {good, corners + "3 0 x 2\n", "'x' is not a number"},
        {good, corners + "-1 0 1 2\n", "a list of -1 cannot be"},
        {good, corners + "200 0 1 2\n", "a list of 200 cannot be"},
        {good, corners + "2 0 1\n", "has no triangles"},
        {good, corners + "3 0 0 0\n", "none of its 1 triangles has an area"},
        {good, "nan 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "vertex 0 is at (nan, 0, 0)"},
        {good, "0 0 inf\n1 0 0\n0 1 0\n3 0 1 2\n", "vertex 0 is at (0, 0, inf)"},
        {good, "1e999 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "vertex 0 is at (inf"},
        {ascii + "element vertex 999999999999\n" + vertex_xyz + face_list, corners, "too short for that"},
        {ascii + "element vertex -1\n" + vertex_xyz + face_list, corners, "line 3: an element needs"},
        {ascii + "element vertex 3\nproperty float x\nproperty float y\n" + face_list, corners, "no x, y and z"},
        {ascii + vertex3, corners, "needs one element 'vertex' and one 'face'"},
        {ascii + vertex3 + "element face 1\nproperty int a\n", corners + "1\n", "no list vertex_indices"},
        {ascii + vertex3 + "property float s\nproperty float t\n" + face_list,
         "0 0 0 0 0\n1 0 0 0 nan\n0 1 0 0 0\n3 0 1 2\n", "the uv of vertex 1 is not finite"},
        {vertex3 + face_list, corners, "has no format"},
        {"format ascii 2.0\n" + vertex3 + face_list, corners, "unknown format 'ascii 2.0'"},
        {ascii + "element vertex 3\nproperty quad x\n", corners, "line 4: unknown type 'quad'"},
        {ascii + "property float x\n", corners, "a property before the first element"},
        {ascii + "wibble\n", corners, "unknown keyword 'wibble'"},
        {"format binary_little_endian 1.0\n" + vertex3 + face_list, "0123", "too short for that"},
    };
    for (const auto &[header, body, fragment] : cases) {
        const std::string message = error(header, body);
        EXPECT_NE(message.find(fragment), std::string::npos) << "'" << message << "' lacks '" << fragment << "'";
        EXPECT_TRUE(message.starts_with((folder / "m.ply").string())) << message;
    }
    put(folder / "m.ply", "plx\n");
    EXPECT_NE(error_of("m.ply").find("does not begin with 'ply'"), std::string::npos);
    put(folder / "m.ply", "ply\nformat ascii 1.0\n");
    EXPECT_NE(error_of("m.ply").find("the header does not end"), std::string::npos);
}

TEST_F(Ply, EveryTruncationOfABinaryFileIsAnError) {
    const std::string whole = tetrahedron_ply("binary_little_endian");
    for (std::size_t size = 0; size < whole.size(); ++size) {
        put(folder / "m.ply", whole.substr(0, size));
        EXPECT_NE(error_of("m.ply"), "") << size;
    }
}

} // namespace
} // namespace nacre
