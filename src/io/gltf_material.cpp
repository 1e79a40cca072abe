#include "io/gltf_draft.h"
#include "io/read_material.h"
#include <fmt/format.h>
#include <set>

namespace nacre::io {

const Json &GltfDraft::extension(const char *name) const {
    static const Json none = Json::object();
    const Json *extensions = gltf_member(json, "extensions");
    const Json *found = extensions ? gltf_member(*extensions, name) : nullptr;
    return found ? *found : none;
}

void GltfDraft::add_texture(const Json &holder, const char *name, shared::Parameter parameter, ColorSpace space,
                            int channel, const Vec3 &factor) {
    const Json *info = gltf_member(holder, name);
    if (!info) return;
    textures.emplace_back(parameter,
                          read_gltf_texture(file, *info, space, channel, where + "." + name, maps, warnings));
    if (factor != Vec3::Ones())
        warn(fmt::format("the factor ({}, {}, {}) of {} is not used, a texture takes the factor's place", factor.x(),
                         factor.y(), factor.z(), name));
}

namespace {

Json to_json(const Vec3 &v) { return {v.x(), v.y(), v.z()}; }

void translate_metallic_roughness(GltfDraft &draft) {
    const Json *member = gltf_member(draft.json, "pbrMetallicRoughness");
    const Json pbr = member ? *member : Json::object();
    const Vec3 color = gltf_color(pbr, "baseColorFactor", Vec3::Ones(), draft.where);
    const double metalness = gltf_number(pbr, "metallicFactor", 1, draft.where);
    const double roughness = gltf_number(pbr, "roughnessFactor", 1, draft.where);
    draft.fields["base_color"] = to_json(color);
    draft.fields["base_metalness"] = metalness;
    draft.fields["specular_roughness"] = roughness;
    draft.add_texture(pbr, "baseColorTexture", shared::PARAMETER_base_color, ColorSpace::srgb, -1, color);
    // One picture for both: roughness in green, metalness in blue.
    draft.add_texture(pbr, "metallicRoughnessTexture", shared::PARAMETER_specular_roughness, ColorSpace::linear, 1,
                      Vec3::Constant(roughness));
    draft.add_texture(pbr, "metallicRoughnessTexture", shared::PARAMETER_base_metalness, ColorSpace::linear, 2,
                      Vec3::Constant(metalness));
}

void translate_specular(GltfDraft &draft) {
    draft.fields["specular_ior"] = gltf_number(draft.extension("KHR_materials_ior"), "ior", 1.5, draft.where);
    const Json &specular = draft.extension("KHR_materials_specular");
    const double weight = gltf_number(specular, "specularFactor", 1, draft.where);
    draft.fields["specular_weight"] = weight;
    draft.add_texture(specular, "specularTexture", shared::PARAMETER_specular_weight, ColorSpace::linear, 3,
                      Vec3::Constant(weight));
    if (specular.contains("specularColorFactor") || specular.contains("specularColorTexture"))
        draft.warn("the colour of KHR_materials_specular is not used");
}

void translate_emission(GltfDraft &draft) {
    const Vec3 factor = gltf_color(draft.json, "emissiveFactor", Vec3::Zero(), draft.where);
    if (factor == Vec3(0, 0, 0)) return; // black, whatever the texture
    draft.fields["emission_color"] = to_json(factor);
    draft.fields["emission_luminance"] =
        gltf_number(draft.extension("KHR_materials_emissive_strength"), "emissiveStrength", 1, draft.where);
    draft.add_texture(draft.json, "emissiveTexture", shared::PARAMETER_emission_color, ColorSpace::srgb, -1, factor);
}

void translate_normal(GltfDraft &draft) {
    const Json *info = gltf_member(draft.json, "normalTexture");
    if (!info) return;
    draft.add_texture(draft.json, "normalTexture", shared::PARAMETER_geometry_normal, ColorSpace::linear, -1,
                      Vec3::Ones());
    if (gltf_number(*info, "scale", 1, draft.where) != 1) draft.warn("the scale of normalTexture is not used");
}

void warn_of_the_rest(const GltfDraft &draft) {
    static const std::set<std::string> known{"KHR_materials_ior",
                                             "KHR_materials_specular",
                                             "KHR_materials_emissive_strength",
                                             "KHR_materials_transmission",
                                             "KHR_materials_volume",
                                             "KHR_materials_diffuse_transmission",
                                             "KHR_materials_volume_scatter",
                                             "KHR_materials_scatter"};
    if (gltf_member(draft.json, "occlusionTexture")) draft.warn("occlusionTexture is not used, light is traced");
    const Json *alpha = gltf_member(draft.json, "alphaMode");
    if (alpha && *alpha != "OPAQUE") draft.warn("alphaMode is not used, surfaces are opaque");
    if (const Json *extensions = gltf_member(draft.json, "extensions"); extensions && extensions->is_object())
        for (const auto &item : extensions->items())
            if (!known.count(item.key())) draft.warn("the extension " + item.key() + " is not used");
}

} // namespace

scene::Material read_gltf_material(const GltfFile &file, int index, double fallback_radius, Maps &maps,
                                   std::vector<std::string> &warnings) {
    const std::string path = fmt::format("materials.{}", index);
    GltfDraft draft{file, gltf_element(file, "materials", index), file.subject + ": " + path, maps, warnings, {}, {}};
    translate_metallic_roughness(draft);
    translate_specular(draft);
    translate_emission(draft);
    translate_normal(draft);
    translate_scatter(draft, fallback_radius);
    warn_of_the_rest(draft);

    const Source source{file.path, {}};
    scene::Material material;
    read_material(draft.fields, path, source, maps, material);
    for (const auto &[parameter, texture] : draft.textures) material[parameter].texture = texture;
    const Json *extras = gltf_member(draft.json, "extras");
    if (const Json *ours = extras ? gltf_member(*extras, "nacre") : nullptr)
        read_material(*ours, path + ".extras.nacre", source, maps, material);
    return material;
}

} // namespace nacre::io
