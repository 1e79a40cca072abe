// Bad scenes and files, end to end: exit 3, one line that names the file and the fault, nothing written.
// The whole table of what a loader refuses is tests/host; these are the ways in.
#include "cli/cli.h"
#include <filesystem>

namespace nacre {
namespace {

namespace fs = std::filesystem;

// A scene of one ball, with these fields in its material and at its top.
std::string scene(const std::string &material, const std::string &top = "") {
    return R"({"materials": {"skin": {)" + material + R"(}}, "objects": [{"sphere": {}, "material": "skin"}])" + top +
           "}";
}

std::string scene_of_mesh(const std::string &mesh) { return R"({"objects": [{"mesh": ")" + mesh + R"("}]})"; }

struct Case {
    const char *name;
    const char *file; // what is rendered
    std::string text; // what it holds, "": it does not exist
    std::vector<const char *> says;
    std::string mesh_name = "", mesh = ""; // a second file
};

void PrintTo(const Case &c, std::ostream *out) { *out << c.name; }

class BadInput : public Cli, public testing::WithParamInterface<Case> {};

TEST_P(BadInput, ExitThree) {
    const Case &c = GetParam();
    const fs::path inputs = folder / "inputs";
    fs::create_directory(inputs);
    if (!c.text.empty()) put(inputs / c.file, c.text);
    if (!c.mesh_name.empty()) put(inputs / c.mesh_name, c.mesh);
    const Outcome outcome = run(small_render((inputs / c.file).string(), "out.exr"));
    for (const char *text : c.says) expect_error(outcome, 3, text);
    EXPECT_EQ(files(), 1u) << "only the inputs may be there";
}

// A GLB whose header promises more than there is.
const std::string truncated_glb("glTF\2\0\0\0\xff\xff\0\0\x20\0\0\0JSON{}", 22);
const std::string header =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string corners = "0 0 0\n1 0 0\n0 1 0\n";
const std::string faces = "property list uchar int vertex_indices\nend_header\n";

INSTANTIATE_TEST_SUITE_P(
    Cases, BadInput,
    testing::Values(
        Case{"NoScene", "none.json", "", {"none.json", "no such file"}}, Case{"Folder", "../inputs", "", {"inputs"}},
        Case{"OtherFormat", "scene.fbx", "x", {"scene.fbx", ".json"}},
        Case{"NoJson", "scene.json", "{\"objects\": [", {"scene.json"}},
        Case{"NoObjects", "scene.json", "{}", {"objects"}},
        Case{"MisspeltField",
             "scene.json",
             scene(R"("subsurface_wieght": 1)"),
             {"subsurface_wieght", "subsurface_weight"}},
        Case{"MisspeltSection", "scene.json", scene("", R"(, "rendr": {})"), {"rendr", "render"}},
        Case{"WrongType", "scene.json", scene(R"("specular_roughness": "rough")"), {"specular_roughness", "number"}},
        Case{"AnisotropyOutOfRange",
             "scene.json",
             scene(R"("subsurface_scatter_anisotropy": 1)"),
             {"subsurface_scatter_anisotropy"}},
        Case{"NegativeBleed", "scene.json", scene(R"("subsurface_bleed": -0.1)"), {"subsurface_bleed"}},
        Case{"NegativeRadius", "scene.json", scene(R"("subsurface_radius": -1)"), {"subsurface_radius"}},
        Case{"NaN", "scene.json", scene(R"("subsurface_radius": NaN)"), {"scene.json"}},
        Case{"Infinity", "scene.json", scene(R"("subsurface_radius": 1e999)"), {"scene.json"}},
        Case{"UnknownMaterial",
             "scene.json",
             R"({"materials": {"skin": {}}, "objects": [{"sphere": {}, "material": "skim"}]})",
             {"skim", "skin"}},
        Case{"UnknownInversion",
             "scene.json",
             scene(R"("subsurface_inversion": "tables")"),
             {"'tables', did you mean 'table'"}},
        Case{"NoMesh", "scene.json", scene_of_mesh("none.ply"), {"none.ply"}},
        Case{"NoImage",
             "scene.json",
             scene(R"("base_color": {"texture": "a.png"})"),
             {"a.png"},
             "a.png",
             "this is text"},
        Case{"MissingImage", "scene.json", scene(R"("base_color": {"texture": "b.png"})"), {"b.png"}},
        Case{"NoEnvironmentImage",
             "scene.json",
             scene("", R"(, "lights": [{"type": "environment", "image": "sky.hdr"}])"),
             {"sky.hdr"},
             "sky.hdr",
             "#?RADIANCE\n"},
        Case{"TruncatedGlb", "scene.glb", truncated_glb, {"scene.glb"}},
        Case{"EmptyGlb", "scene.json", scene_of_mesh("a.glb"), {"a.glb"}, "a.glb", ""},
        Case{"PlyIndexOutOfRange",
             "scene.json",
             scene_of_mesh("a.ply"),
             {"a.ply", "3"},
             "a.ply",
             header + "element face 1\n" + faces + corners + "3 0 1 3\n"},
        Case{"PlyTruncated",
             "scene.json",
             scene_of_mesh("a.ply"),
             {"a.ply"},
             "a.ply",
             header + "element face 1\n" + faces + "0 0 0\n"},
        Case{"PlyWithoutTriangles", "a.ply", header + "element face 0\n" + faces + corners, {"a.ply"}},
        Case{"ObjIndexOutOfRange", "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", {"a.obj", "4"}},
        Case{"EmptyObj", "a.obj", "# nothing\n", {"a.obj"}}),
    [](const auto &info) { return info.param.name; });

TEST_F(Cli, BadSetNamesThePath) {
    expect_error(run(small_render(ball, "out.exr", {"--set", "render.sps=3"})), 3, "render.sps");
    expect_error(run(small_render(ball, "out.exr", {"--set", "render.spp=many"})), 3, "render.spp");
    EXPECT_EQ(files(), 0u);
}

TEST_F(Cli, CheckRefusesWhatRenderRefuses) {
    put(folder / "scene.json", scene(R"("subsurface_wieght": 1)"));
    expect_error(run({"check", path("scene.json")}), 3, "subsurface_weight");
}

} // namespace
} // namespace nacre
