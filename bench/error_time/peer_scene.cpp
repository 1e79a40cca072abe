// A scene as other renderers' scripts read it.
#include "albedo/inversion.h"
#include "base/error.h"
#include "error_time/peers.h"
#include "io/image.h"
#include "measure.h"
#include <Imath/half.h>
#include <fmt/format.h>
#include <fstream>

namespace nacre::bench {
namespace {

using namespace shared;
using Json = nlohmann::json;

Json array(const Vec3 &v) { return {v.x(), v.y(), v.z()}; }

template <typename Values>
std::string write_numbers(const std::string &folder, const std::string &name, const Values &values) {
    const std::string file = folder + "/" + name;
    std::ofstream out(file, std::ios::binary);
    out.write(reinterpret_cast<const char *>(values.data()), std::streamsize(values.size() * sizeof(values[0])));
    if (!out.flush()) throw Error(Exit::output, file, "cannot be written");
    return file;
}

/// The picture of a colour as linear EXR.
std::string write_texture(const std::string &folder, const scene::Scene &scene, const scene::Texture &texture) {
    const scene::Image &image = scene.images[texture.image];
    io::Picture picture;
    picture.width = picture.full_width = int(image.width);
    picture.height = picture.full_height = int(image.height);
    picture.channels = {"R", "G", "B"};
    for (std::size_t i = 0; i < image.halves.size(); i += image.channels)
        for (std::size_t c = 0; c < 3; ++c) {
            Imath::half value;
            value.setBits(image.halves[i + (image.channels > 1 ? c : 0)]);
            picture.pixels.push_back(value);
        }
    const std::string file = fmt::format("{}/texture{}.exr", folder, texture.image);
    io::write_picture(file, picture, 0);
    return file;
}

const scene::Texture *color_texture(const scene::Scene &scene, const scene::Material &material) {
    const int index = material[PARAMETER_subsurface_color].texture;
    return index < 0 ? nullptr : &scene.textures[std::size_t(index)];
}

/// What the scripts do not know.
std::string refusal(const scene::Scene &scene) {
    if (scene.camera.kind != CAMERA_PERSPECTIVE) return "a camera that is not perspective";
    for (const scene::Light &light : scene.lights)
        if (light.kind != LIGHT_RECT && (light.kind != LIGHT_ENVIRONMENT || light.width > 0))
            return "a light of another kind";
    for (const scene::Material &material : scene.materials) {
        const Vec3 weight = material[PARAMETER_subsurface_weight].value;
        if (!weight.isZero() && weight != Vec3::Ones()) return "a subsurface_weight between 0 and 1";
        if (!material[PARAMETER_subsurface_bleed].value.isZero()) return "bleed";
        for (int i = 0; i < PARAMETER_COUNT; ++i)
            if (i != PARAMETER_subsurface_color && material[Parameter(i)].texture >= 0)
                return "a texture beside that of colour";
    }
    return {};
}

Json material_json(const std::string &folder, const scene::Scene &scene, const scene::Material &material) {
    const Vec3 radius =
        material[PARAMETER_subsurface_radius].value.cwiseProduct(material[PARAMETER_subsurface_radius_scale].value);
    Json json = {{"subsurface", !material[PARAMETER_subsurface_weight].value.isZero()},
                 {"subsurface_color", array(material[PARAMETER_subsurface_color].value)},
                 {"mean_free_path", array(radius)},
                 {"g", material[PARAMETER_subsurface_scatter_anisotropy].value.x()},
                 {"base_color", array(material[PARAMETER_base_color].value)},
                 {"specular", material[PARAMETER_specular_weight].value.x()},
                 {"roughness", material[PARAMETER_specular_roughness].value.x()},
                 {"ior", material[PARAMETER_specular_ior].value.x()}};
    const Vec3 color = material[PARAMETER_subsurface_color].value;
    albedo::Medium medium{material[PARAMETER_subsurface_scatter_anisotropy].value.x()};
    medium.entry = material.entry;
    Vec3 albedo;
    for (int c = 0; c < 3; ++c) albedo[c] = albedo::albedo(material.inversion, color[c], medium);
    json["albedo"] = array(albedo); // where there is no texture
    if (const scene::Texture *texture = color_texture(scene, material))
        json["texture"] = write_texture(folder, scene, *texture);
    return json;
}

/// Positions in world space; uvs as the colour's texture reads them.
Json object_json(const std::string &folder, const scene::Scene &scene, std::size_t index) {
    const scene::Object &object = scene.objects[index];
    const auto name = [&](const char *what) { return fmt::format("{}{}", what, index); };
    std::vector<Vec3f> positions;
    for (const Vec3 &position : object.mesh.positions) positions.push_back(position.cast<float>());
    Json json = {{"material", object.material},
                 {"positions", write_numbers(folder, name("positions"), positions)},
                 {"triangles", write_numbers(folder, name("triangles"), object.mesh.triangles)}};
    if (!object.mesh.normals.empty()) json["normals"] = write_numbers(folder, name("normals"), object.mesh.normals);
    const scene::Texture *texture = color_texture(scene, scene.materials[object.material]);
    if (texture && !object.mesh.uvs.empty()) {
        std::vector<Vec2f> uvs;
        for (const Vec2f &uv : object.mesh.uvs)
            uvs.push_back((uv.cast<double>().cwiseProduct(texture->scale) + texture->offset).cast<float>());
        json["uvs"] = write_numbers(folder, name("uvs"), uvs);
    }
    return json;
}

} // namespace

std::string export_scene(const std::string &folder, const scene::Scene &scene) {
    if (const std::string why = refusal(scene); !why.empty()) return why;
    const scene::Camera &camera = scene.camera;
    Json json = {{"width", scene.image.width},
                 {"height", scene.image.height},
                 {"max_depth", scene.render.max_depth},
                 {"camera",
                  {{"position", array(camera.position)},
                   {"target", array(camera.target)},
                   {"up", array(camera.up)},
                   {"fov", camera.fov}}},
                 {"environment", {0, 0, 0}},
                 {"environment_visible", false},
                 {"rects", Json::array()}};
    for (const scene::Light &light : scene.lights) {
        if (light.kind == LIGHT_ENVIRONMENT) {
            json["environment"] = array(light.radiance);
            json["environment_visible"] = light.visible;
        } else {
            json["rects"].push_back({{"center", array(light.position)},
                                     {"u", array(light.u)},
                                     {"v", array(light.v)},
                                     {"radiance", array(light.radiance)}});
        }
    }
    for (const scene::Material &material : scene.materials)
        json["materials"].push_back(material_json(folder, scene, material));
    for (std::size_t i = 0; i < scene.objects.size(); ++i) json["objects"].push_back(object_json(folder, scene, i));
    write_json(folder + "/scene.json", json);
    return {};
}

} // namespace nacre::bench
