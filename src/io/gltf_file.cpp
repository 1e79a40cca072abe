#include "io/gltf_file.h"
#include "base/error.h"
#include "io/extension.h"
#include "io/fields.h"
#include "io/find_file.h"
#include "io/glb.h"
#include <algorithm>
#include <set>

namespace nacre::io {

namespace {

// tinygltf reads these unchecked (images through unchecked buffer views), or recursively (extras, extensions), and
// nacre does not need them from it.
Json for_tinygltf(const Json &json) {
    Json reduced = Json::object();
    for (const char *name :
         {"asset", "scene", "scenes", "nodes", "meshes", "accessors", "bufferViews", "buffers", "cameras"})
        if (const Json *member = gltf_member(json, name)) reduced[name] = *member;
    const auto strip = [](Json &object) {
        if (!object.is_object()) return;
        object.erase("extras");
        object.erase("extensions");
    };
    for (auto &section : reduced)
        if (section.is_array())
            for (Json &element : section) {
                strip(element);
                if (element.is_object() && element.contains("primitives") && element["primitives"].is_array())
                    for (Json &primitive : element["primitives"]) strip(primitive);
            }
    return reduced;
}

// The file system of tinygltf expands names as a shell would; names in files are to be taken as they are.
std::string same_name(const std::string &name, void *) { return name; }

void parse_model(GltfFile &file, std::string_view binary) {
    tinygltf::TinyGLTF parser;
    parser.SetFsCallbacks(
        {&tinygltf::FileExists, &same_name, &tinygltf::ReadWholeFile, &tinygltf::WriteWholeFile, nullptr});
    const std::string json = for_tinygltf(file.json).dump();
    const std::string folder = file.path.parent_path().empty() ? "." : file.path.parent_path().string();
    std::string error, warning;
    bool good = false;
    try {
        if (binary.empty()) {
            good = parser.LoadASCIIFromString(&file.model, &error, &warning, json.data(), json.size(), folder, 0);
        } else {
            const std::string glb = join_glb({json, binary});
            good =
                parser.LoadBinaryFromMemory(&file.model, &error, &warning,
                                            reinterpret_cast<const unsigned char *>(glb.data()), glb.size(), folder, 0);
        }
    } catch (const std::exception &exception) { // an empty buffer: vector::at
        error = exception.what();
    }
    std::replace(error.begin(), error.end(), '\n', ' ');
    if (!good) input_error(file.subject, "is not valid glTF: {}", error);
}

// An extension that a file cannot do without and that changes more than a material's look.
void check_required(const GltfFile &file) {
    static const std::set<std::string> supported{"KHR_mesh_quantization", "KHR_texture_transform",
                                                 "KHR_lights_punctual"};
    const Json *required = gltf_member(file.json, "extensionsRequired");
    if (!required || !required->is_array()) return;
    for (const Json &name : *required)
        if (!name.is_string() ||
            (!supported.count(name.get<std::string>()) && !name.get<std::string>().starts_with("KHR_materials_")))
            input_error(file.subject, "needs the glTF extension {}, which nacre does not have", describe(name));
}

} // namespace

GltfFile load_gltf_file(const std::filesystem::path &path) {
    GltfFile file{path, path.string(), {}, {}};
    const std::string bytes = read_file(path);
    const bool binary = extension_of(path) == ".glb";
    const Glb parts = binary ? split_glb(bytes, file.subject) : Glb{bytes, {}};
    file.json = parse_json(std::string(parts.json), file.subject);
    if (!file.json.is_object()) input_error(file.subject, "is not valid glTF: expected an object");
    check_required(file);
    parse_model(file, parts.binary);
    return file;
}

const Json *gltf_member(const Json &object, const char *name) {
    if (!object.is_object()) return nullptr;
    const auto found = object.find(name);
    return found == object.end() ? nullptr : &*found;
}

double gltf_number(const Json &object, const char *name, double fallback, const std::string &where) {
    const Json *member = gltf_member(object, name);
    if (!member) return fallback;
    if (!member->is_number()) input_error(where, "{}: expected a number, got {}", name, describe(*member));
    return member->get<double>();
}

int gltf_index(const Json &object, const char *name, const std::string &where) {
    const double index = gltf_number(object, name, -1, where);
    if (!(index >= -1 && index < 2147483647.0)) input_error(where, "{}: {} is not an index", name, index);
    return static_cast<int>(index);
}

Vec3 gltf_color(const Json &object, const char *name, const Vec3 &fallback, const std::string &where) {
    const Json *member = gltf_member(object, name);
    if (!member) return fallback;
    const bool numbers = member->is_array() && member->size() >= 3 &&
                         std::all_of(member->begin(), member->end(), [](const Json &v) { return v.is_number(); });
    if (!numbers) input_error(where, "{}: expected three numbers, got {}", name, describe(*member));
    return {(*member)[0].get<double>(), (*member)[1].get<double>(), (*member)[2].get<double>()};
}

const Json &gltf_element(const GltfFile &file, const char *name, int index) {
    const Json *array = gltf_member(file.json, name);
    if (!array || !array->is_array() || index < 0 || static_cast<std::size_t>(index) >= array->size())
        input_error(file.subject, "{}: there is no element {}", name, index);
    return (*array)[index];
}

} // namespace nacre::io
