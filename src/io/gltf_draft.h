#pragma once
#include "io/gltf_material.h"

namespace nacre::io {

/// A glTF material on its way to one of nacre's. Numbers become the nacre JSON that stands for them, so that they are
/// checked like a user's; textures are kept apart, since they may be inside the file.
struct GltfDraft {
    const GltfFile &file;
    const Json &json;
    const std::string where; // for messages
    Maps &maps;
    std::vector<std::string> &warnings;
    Json fields = Json::object();
    std::vector<std::pair<shared::Parameter, int>> textures;

    /// An extension of the material; an empty object where it has none.
    const Json &extension(const char *name) const;

    /// Reads texture `name` of `holder`, if it is there, to replace `parameter`. nacre's textures replace a number,
    /// glTF's multiply it: a `factor` other than 1 is lost, and a warning says so. `channel` -1: all.
    void add_texture(const Json &holder, const char *name, shared::Parameter parameter, ColorSpace space, int channel,
                     const Vec3 &factor);

    void warn(const std::string &message) const { warnings.push_back(where + ": " + message); }
};

/// KHR_materials_transmission, _diffuse_transmission, _volume, _volume_scatter and _scatter: what is under the surface.
void translate_scatter(GltfDraft &draft, double fallback_radius);

} // namespace nacre::io
