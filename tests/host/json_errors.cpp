#include "host/scene_folder.h"

namespace nacre {
namespace {

class JsonErrors : public SceneFolder {
  protected:
    // Every one of the fragments is in the message, which begins with the file.
    void expect_error(const std::string &json, const std::vector<std::string> &fragments) {
        put(folder / "scene.json", json);
        const std::string message = error_of("scene.json");
        EXPECT_FALSE(message.empty()) << "loads: " << json.substr(0, 200);
        EXPECT_TRUE(message.starts_with((folder / "scene.json").string() + ": ")) << message;
        for (const std::string &fragment : fragments)
            EXPECT_NE(message.find(fragment), std::string::npos)
                << "'" << fragment << "' is not in '" << message << "', of " << json.substr(0, 200);
    }
};

struct Case {
    std::string json;
    std::vector<std::string> fragments;
};

std::string material(const std::string &fields) {
    return R"({"materials": {"skin": {)" + fields +
           R"(}}, "objects": [{"sphere": {"segments": 4}, "material": "skin"}]})";
}
std::string object(const std::string &fields) { return R"({"objects": [{)" + fields + "}]}"; }
std::string section(const std::string &text) { return "{" + text + R"(, "objects": [{"sphere": {"segments": 4}}]})"; }
std::string light(const std::string &fields) { return section(R"("lights": [{)" + fields + "}]"); }

TEST_F(JsonErrors, Syntax) {
    const Case cases[] = {
        {"", {"not valid JSON", "line 1, column 1"}},
        {"{\n  \"objects\": [}\n", {"line 2, column 15"}},
        {"{\"objects\": [{\"sphere\": {\"radius\": 1e999}}]}", {"not valid JSON", "1e999"}},
        {"{\"objects\": [{\"sphere\": {\"radius\": NaN}}]}", {"not valid JSON"}},
        {"{\"a\": \"\xff\"}", {"not valid JSON"}},
        {"[1, 2]", {"expected an object, got an array of 2"}},
        {"3", {"expected an object, got 3"}},
        {R"({"image": {}, "image": {}})", {"'image' is given twice"}},
        {material(R"("base_color": 1, "base_color": 1)"), {"'base_color' is given twice"}},
        {std::string(1000, '['), {"nested deeper"}},
        {std::string(1000000, '['), {"nested deeper"}},
        {R"({"objects": )" + std::string(100, '[') + std::string(100, ']') + "}", {"nested deeper"}},
    };
    for (const auto &[json, fragments] : cases) expect_error(json, fragments);
}

TEST_F(JsonErrors, UnknownFields) {
    const Case cases[] = {
        {material(R"("subsurface_colour": 1)"),
         {"materials.skin.subsurface_colour: unknown field, did you mean 'subsurface_color'?"}},
        {material(R"("colour": 1)"), {"materials.skin.colour: unknown field; known: base_color"}},
        {section(R"("camra": {})"), {"camra: unknown field, did you mean 'camera'?"}},
        {section(R"("camera": {"positon": [0,0,1]})"), {"camera.positon: unknown field, did you mean 'position'?"}},
        {section(R"("image": {"hieght": 1})"), {"image.hieght: unknown field, did you mean 'height'?"}},
        {section(R"("render": {"sp": 1})"), {"render.sp: unknown field, did you mean 'spp'?"}},
        {section(R"("device": {"lane": 1})"), {"device.lane: unknown field, did you mean 'lanes'?"}},
        {object(R"("sphere": {"centre": [0,0,0]})"), {"objects.0.sphere.centre", "did you mean 'center'?"}},
        {object(R"("box": {"maximum": [0,0,0]})"), {"objects.0.box.maximum"}},
        {object(R"("sphere": {}, "transform": {"rotation": 1})"),
         {"objects.0.transform.rotation: unknown field; known: scale, rotate"}},
        {object(R"("spher": {})"), {"objects.0.spher: unknown field, did you mean 'sphere'?"}},
        {light(R"("type": "point", "radiance": 1)"), {"lights.0.radiance: unknown field"}},
        {light(R"("type": "environment", "radience": 1)"), {"lights.0.radience", "did you mean 'radiance'?"}},
        {material(R"("base_color": {"texture": "a.png", "colourspace": "srgb"})"),
         {"materials.skin.base_color.colourspace", "did you mean 'colorspace'?"}},
    };
    for (const auto &[json, fragments] : cases) expect_error(json, fragments);
}

TEST_F(JsonErrors, Types) {
    const Case cases[] = {
        {section(R"("camera": 3)"), {"camera: expected an object, got 3"}},
        {section(R"("camera": null)"), {"camera: expected an object, got null"}},
        {section(R"("camera": {"fov": "wide"})"), {"camera.fov: expected a number, got \"wide\""}},
        {section(R"("camera": {"position": [0, 1]})"), {"camera.position: expected 3 numbers, got an array of 2"}},
        {section(R"("camera": {"position": [0, 1, "z"]})"), {"camera.position: expected a number, got \"z\""}},
        {section(R"("image": {"width": 2.5})"), {"image.width: 2.5 is out of range, must be a whole number"}},
        {section(R"("image": {"width": true})"), {"image.width: expected a number, got true"}},
        {section(R"("device": {"lanes": 3})"), {"device.lanes: must be 1, 4, 8 or 16, or 0 for what suits the device"}},
        {section(R"("render": {"clearance": 1})"), {"render.clearance: expected true or false, got 1"}},
        {material(R"("subsurface_internal_reflection": 1)"), {"_reflection: expected true or false, got 1"}},
        {section(R"("materials": [])"), {"materials: expected an object"}},
        {section(R"("lights": {})"), {"lights: expected an array"}},
        {section(R"("lights": [3])"), {"lights.0: expected an object, got 3"}},
        {material(R"("base_color": [1, 1])"), {"materials.skin.base_color: expected a number or three"}},
        {material(R"("base_color": "red")"), {"base_color: expected a number or three, got \"red\""}},
        {material(R"("subsurface_radius": [1, 1, 1])"), {"subsurface_radius: expected a number, got an array of 3"}},
        {material(R"("geometry_normal": 1)"), {"geometry_normal: expected {\"texture\": FILE}"}},
        {material(R"("base_color": {})"), {"base_color: expected a value or {\"texture\": FILE}"}},
        {object(R"("mesh": 3)"), {"objects.0.mesh: expected a string, got 3"}},
        {R"({"objects": {}})", {"objects: expected an array of objects"}},
        {R"({"objects": []})", {"objects: expected an array of objects"}},
        {"{}", {"objects: is missing"}},
    };
    for (const auto &[json, fragments] : cases) expect_error(json, fragments);
}

TEST_F(JsonErrors, Ranges) {
    const Case cases[] = {
        {material(R"("subsurface_scatter_anisotropy": 1)"), {"anisotropy: 1 is out of range, must be in [-0.9999"}},
        {material(R"("subsurface_scatter_anisotropy": -1)"), {"anisotropy: -1 is out of range"}},
        {material(R"("subsurface_bleed": -0.1)"), {"subsurface_bleed: -0.1 is out of range"}},
        {material(R"("subsurface_radius": 0)"), {"subsurface_radius: 0 is out of range, must be above 0"}},
        {material(R"("subsurface_radius": -1)"), {"subsurface_radius: -1 is out of range"}},
        {material(R"("subsurface_radius_scale": [1, 0, 1])"), {"subsurface_radius_scale: 0 is out of range"}},
        {material(R"("specular_roughness": 1.5)"), {"specular_roughness: 1.5 is out of range, must be in [0, 1]"}},
        {material(R"("specular_ior": 0.9)"), {"specular_ior: 0.9 is out of range"}},
        {material(R"("subsurface_color": [0, 0, 1.2])"), {"subsurface_color: 1.2 is out of range"}},
        {material(R"("emission_luminance": -1)"), {"emission_luminance: -1 is out of range"}},
        {material(R"("subsurface_max_depth": -1)"), {"subsurface_max_depth: -1 is out of range"}},
        {section(R"("camera": {"fov": 0})"), {"camera.fov: 0 is out of range, must be in (0, 180)"}},
        {section(R"("camera": {"fov": 180})"), {"camera.fov: 180 is out of range"}},
        {section(R"("camera": {"position": [1e31, 0, 0]})"), {"camera.position: 1e+31 is out of range"}},
        {section(R"("camera": {"position": [0,0,1], "target": [0,0,1]})"), {"camera.target: is where the camera is"}},
        {section(R"("camera": {"position": [0,5,0], "target": [0,0,0]})"), {"camera.up: is along"}},
        {section(R"("camera": {"up": [0,0,0]})"), {"camera.up: is along"}},
        {material(R"("subsurface_model": "burly")"),
         {"subsurface_model: unknown value 'burly', did you mean 'burley'?"}},
        {material(R"("subsurface_model": "bssrdf")"), {"random_walk", "dipole", "better_dipole", "burley"}},
        {section(R"("image": {"width": 0})"), {"image.width: 0 is out of range"}},
        {section(R"("image": {"height": 65537})"), {"image.height: 65537 is out of range"}},
        {section(R"("render": {"spp": 0})"), {"render.spp: 0 is out of range"}},
        {section(R"("render": {"seed": -1})"), {"render.seed: -1 is out of range"}},
        {section(R"("render": {"seed": 4294967296})"), {"render.seed: 4294967296 is out of range"}},
        {light(R"("type": "point", "intensity": -1)"), {"lights.0.intensity: -1 is out of range"}},
        {light(R"("type": "environment", "radiance": [0, -1, 0])"), {"lights.0.radiance: -1 is out of range"}},
        {light(R"("type": "directional", "direction": [0,0,0])"), {"lights.0.direction: has no length"}},
        {light(R"("type": "rect", "u": [1,0,0], "v": [2,0,0])"), {"lights.0.v: u and v span no area"}},
        {object(R"("sphere": {"radius": 0})"), {"objects.0.sphere.radius: 0 is out of range"}},
        {object(R"("sphere": {"segments": 3})"), {"objects.0.sphere.segments: 3 is out of range"}},
        {object(R"("box": {"min": [0,0,0], "max": [1,0,1]})"), {"objects.0.box.max: must be greater than min"}},
        {object(R"("box": {}, "transform": {"scale": 0})"), {"objects.0: none of its 12 triangles has an area"}},
        {object(R"("box": {"max": [1e20, 1, 1]}, "transform": {"scale": 1e20})"), {"objects.0: vertex", "finite"}},
    };
    for (const auto &[json, fragments] : cases) expect_error(json, fragments);
}

TEST_F(JsonErrors, NotBuiltYet) {
    const Case cases[] = {
        {section(R"("render": {"guiding": "eigne"})"), {"unknown value 'eigne', did you mean 'eigen'?"}},
        {material(R"("subsurface_inversion": "hulst")"), {"table", "memo", "van_de_hulst", "chiang", "none"}},
    };
    for (const auto &[json, fragments] : cases) expect_error(json, fragments);
}

TEST_F(JsonErrors, References) {
    unsetenv("NACRE_ASSETS"); // the message names it where it is not set
    put(folder / "note.txt", "hello");
    put(folder / "bad.png", "not a picture");
    const Case cases[] = {
        {R"({"materials": {"skin": {}}, "objects": [{"sphere": {}, "material": "skim"}]})",
         {"objects.0.material: there is no material 'skim', did you mean 'skin'?"}},
        {object(R"("mesh": "head.ply")"), {"objects.0.mesh: there is no file 'head.ply', looked in", "NACRE_ASSETS"}},
        {object(R"("mesh": "note.txt")"), {"objects.0.mesh: 'note.txt' is not a mesh"}},
        {object(R"("mesh": "")"), {"objects.0.mesh: there is no file ''"}},
        {object(R"("mesh": "/")"), {"objects.0.mesh: there is no file '/'"}},
        {object(R"("material": "x", "sphere": {})"), {"objects.0.material: there is no material 'x'"}},
        {object(R"("sphere": {}, "box": {})"), {"objects.0: needs exactly one of mesh, sphere, box"}},
        {object(R"("smooth": true)"), {"objects.0: needs exactly one of mesh, sphere, box"}},
        {material(R"("base_color": {"texture": "gone.png"})"), {"base_color.texture: there is no file 'gone.png'"}},
        {light(R"("type": "environment", "image": "gone.hdr")"), {"lights.0.image: there is no file 'gone.hdr'"}},
        {light(R"("type": "sun")"), {"lights.0.type: unknown value 'sun'"}},
        {light(R"("radiance": 1)"), {"lights.0.type: is missing"}},
        {material(R"("subsurface_albedo": 1, "subsurface_color": 1)"), {"give one of them"}},
        {material(R"("subsurface_albedo": 1, "subsurface_inversion": "van_de_hulst")"), {"nothing to invert"}},
        {material(R"("base_color": {"texture": "a.png", "colorspace": "aces"})"), {"unknown value 'aces'"}},
    };
    for (const auto &[json, fragments] : cases) expect_error(json, fragments);
    put(folder / "scene.json", material(R"("base_color": {"texture": "bad.png"})"));
    EXPECT_NE(error_of("scene.json").find("bad.png"), std::string::npos);
}

TEST_F(JsonErrors, Files) {
    EXPECT_NE(error_of("gone.json").find("gone.json: there is no such file"), std::string::npos);
    put(folder / "scene.usd", "");
    EXPECT_NE(error_of("scene.usd").find("not a scene nacre reads"), std::string::npos);
    std::filesystem::create_directories(folder / "folder.json");
    EXPECT_NE(error_of("folder.json").find("is a folder"), std::string::npos);
}

} // namespace
} // namespace nacre
