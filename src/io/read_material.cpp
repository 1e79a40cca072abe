#include "io/read_material.h"
#include "io/find_file.h"
#include <fmt/format.h>

namespace nacre::io {

namespace {

enum class Kind { number, color, normal };

struct ParameterField {
    shared::Parameter parameter;
    const char *name;
    Kind kind;
};

// subsurface_scatter_anisotropy is not here: it may be three numbers, see below.
constexpr ParameterField parameter_fields[] = {
    {shared::PARAMETER_base_color, "base_color", Kind::color},
    {shared::PARAMETER_base_metalness, "base_metalness", Kind::number},
    {shared::PARAMETER_specular_weight, "specular_weight", Kind::number},
    {shared::PARAMETER_specular_roughness, "specular_roughness", Kind::number},
    {shared::PARAMETER_specular_ior, "specular_ior", Kind::number},
    {shared::PARAMETER_emission_luminance, "emission_luminance", Kind::number},
    {shared::PARAMETER_emission_color, "emission_color", Kind::color},
    {shared::PARAMETER_subsurface_weight, "subsurface_weight", Kind::number},
    {shared::PARAMETER_subsurface_color, "subsurface_color", Kind::color},
    {shared::PARAMETER_subsurface_radius, "subsurface_radius", Kind::number},
    {shared::PARAMETER_subsurface_radius_scale, "subsurface_radius_scale", Kind::color},
    {shared::PARAMETER_subsurface_bleed, "subsurface_bleed", Kind::number},
    {shared::PARAMETER_geometry_normal, "geometry_normal", Kind::normal},
};

constexpr Choice flights[] = {{"renewal", shared::FLIGHT_RENEWAL}, {"reciprocal", shared::FLIGHT_RECIPROCAL}};
constexpr Choice inversions[] = {{"table", shared::INVERSION_TABLE},
                                 {"memo", shared::INVERSION_MEMO},
                                 {"van_de_hulst", shared::INVERSION_VAN_DE_HULST},
                                 {"chiang", shared::INVERSION_CHIANG},
                                 {"none", shared::INVERSION_NONE}};
constexpr Choice entries[] = {
    {"lambert", shared::ENTRY_LAMBERT}, {"uniform", shared::ENTRY_UNIFORM}, {"refracted", shared::ENTRY_REFRACTED}};
constexpr Choice models[] = {{"random_walk", shared::MODEL_RANDOM_WALK},
                             {"dipole", shared::MODEL_DIPOLE},
                             {"better_dipole", shared::MODEL_BETTER_DIPOLE},
                             {"burley", shared::MODEL_BURLEY}};
constexpr Choice color_spaces[] = {{"srgb", static_cast<int>(ColorSpace::srgb)},
                                   {"linear", static_cast<int>(ColorSpace::linear)}};

int read_texture(const Json &tree, const std::string &path, const Source &source, Maps &maps, Kind kind) {
    Fields fields(tree, path, "texture", source);
    std::string name;
    ColorSpace space = kind == Kind::color ? ColorSpace::srgb : ColorSpace::linear;
    scene::Texture texture;
    fields.read("texture", name);
    fields.read_choice("colorspace", color_spaces, space);
    fields.read("scale", texture.scale);
    fields.read("offset", texture.offset);
    fields.finish();
    if (name.empty()) source.fail(path, "expected a value or {\"texture\": FILE}, this object names no file");
    texture.image = maps.load(find_file(source, fields.path("texture"), name), space);
    return maps.add(texture, kind == Kind::number);
}

void read_value(Fields &fields, const char *name, Kind kind, Maps &maps, scene::Value &value) {
    const Json *found = fields.find(name);
    if (!found) return;
    if (found->is_object()) {
        value.texture = read_texture(*found, fields.path(name), fields.source(), maps, kind);
        return;
    }
    if (kind == Kind::normal)
        fields.fail(name, fmt::format("expected {{\"texture\": FILE}}, got {}", describe(*found)));
    if (kind == Kind::color) {
        fields.read_color(name, value.value);
    } else {
        double number = 0;
        fields.read(name, number);
        value.value = Vec3::Constant(number);
    }
    value.texture = -1;
}

void read_anisotropy(Fields &fields, Maps &maps, scene::Value &value) {
    constexpr const char *name = "subsurface_scatter_anisotropy";
    const Json *found = fields.find(name);
    if (!found || !found->is_array()) return read_value(fields, name, Kind::number, maps, value);
    fields.read(name, value.value);
    value.texture = -1;
}

// The albedo takes the colour's place: it needs no inversion.
void read_albedo(Fields &fields, Maps &maps, scene::Material &material) {
    if (!fields.find("subsurface_albedo")) return;
    if (fields.find("subsurface_color"))
        fields.fail("subsurface_albedo", "is given together with subsurface_color, give one of them");
    if (fields.find("subsurface_inversion") && material.inversion != shared::INVERSION_NONE)
        fields.fail("subsurface_inversion", "has nothing to invert where subsurface_albedo is given, leave it out");
    read_value(fields, "subsurface_albedo", Kind::color, maps, material[shared::PARAMETER_subsurface_color]);
    material.inversion = shared::INVERSION_NONE;
}

} // namespace

void read_material(const Json &tree, const std::string &path, const Source &source, Maps &maps,
                   scene::Material &material) {
    Fields fields(tree, path, "material", source);
    for (const ParameterField &field : parameter_fields)
        read_value(fields, field.name, field.kind, maps, material[field.parameter]);
    read_anisotropy(fields, maps, material[shared::PARAMETER_subsurface_scatter_anisotropy]);
    fields.read_choice("subsurface_flight", flights, material.flight);
    fields.read_choice("subsurface_inversion", inversions, material.inversion);
    fields.read_choice("subsurface_entry", entries, material.entry);
    fields.read("subsurface_internal_reflection", material.internal_reflection);
    fields.read_choice("subsurface_model", models, material.model);
    fields.read("subsurface_max_depth", material.max_depth);
    read_albedo(fields, maps, material);
    fields.finish();
}

} // namespace nacre::io
