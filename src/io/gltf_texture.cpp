#include "base/error.h"
#include "io/find_file.h"
#include "io/gltf_material.h"

namespace nacre::io {

namespace {

// "a%20b" -> "a b" (RFC 3986, section 2.1).
std::string percent_decoded(const std::string &uri) {
    std::string decoded;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const std::string digits = uri.substr(i + 1, 2);
        if (uri[i] == '%' && digits.size() == 2 && std::isxdigit(static_cast<unsigned char>(digits[0])) &&
            std::isxdigit(static_cast<unsigned char>(digits[1]))) {
            decoded.push_back(static_cast<char>(std::stoi(digits, nullptr, 16)));
            i += 2;
        } else {
            decoded.push_back(uri[i]);
        }
    }
    return decoded;
}

std::uint32_t decode_view(const GltfFile &file, int view, const std::string &name, ColorSpace space, Maps &maps) {
    const tinygltf::Model &model = file.model;
    if (view < 0 || static_cast<std::size_t>(view) >= model.bufferViews.size())
        input_error(name, "there is no buffer view {}", view);
    const tinygltf::BufferView &range = model.bufferViews[view];
    if (range.buffer < 0 || static_cast<std::size_t>(range.buffer) >= model.buffers.size())
        input_error(name, "there is no buffer {}", range.buffer);
    const std::vector<unsigned char> &bytes = model.buffers[range.buffer].data;
    if (range.byteOffset > bytes.size() || range.byteLength > bytes.size() - range.byteOffset)
        input_error(name, "its buffer view goes beyond the buffer");
    return maps.decode({bytes.data() + range.byteOffset, range.byteLength}, name, space);
}

std::uint32_t load_image(const GltfFile &file, int index, ColorSpace space, Maps &maps) {
    const Json &image = gltf_element(file, "images", index);
    const std::string name = fmt::format("{}: images.{}", file.subject, index);
    const Json *uri = gltf_member(image, "uri");
    if (!uri || !uri->is_string()) return decode_view(file, gltf_index(image, "bufferView", name), name, space, maps);
    const std::string text = uri->get<std::string>();
    if (tinygltf::IsDataURI(text)) {
        std::vector<unsigned char> bytes;
        std::string mime_type;
        if (!tinygltf::DecodeDataURI(&bytes, mime_type, text, 0, false))
            input_error(name, "its data URI cannot be decoded");
        return maps.decode(bytes, name, space);
    }
    std::string looked;
    const std::filesystem::path found = find_file(file.path, percent_decoded(text), looked);
    if (found.empty())
        throw MissingFile(name, fmt::format("there is no file '{}', looked in {}", percent_decoded(text), looked));
    return maps.load(found, space);
}

// KHR_texture_transform, which is in glTF's uvs, whose v goes down: v -> 1 - v on both sides.
void read_transform(const Json &info, const std::string &where, scene::Texture &texture,
                    std::vector<std::string> &warnings) {
    const Json *extensions = gltf_member(info, "extensions");
    const Json *transform = extensions ? gltf_member(*extensions, "KHR_texture_transform") : nullptr;
    if (!transform) return;
    const auto pair = [&](const char *name, const Vec2 &fallback) -> Vec2 {
        const Json *member = gltf_member(*transform, name);
        if (!member) return fallback;
        if (!member->is_array() || member->size() != 2 || !(*member)[0].is_number() || !(*member)[1].is_number())
            input_error(where, "{}: expected two numbers", name);
        return {(*member)[0].get<double>(), (*member)[1].get<double>()};
    };
    const Vec2 scale = pair("scale", {1, 1}), offset = pair("offset", {0, 0});
    texture.scale = scale;
    texture.offset = {offset.x(), 1 - scale.y() - offset.y()};
    if (gltf_number(*transform, "rotation", 0, where) != 0)
        warnings.push_back(where + ": the rotation of KHR_texture_transform is not used");
}

} // namespace

int read_gltf_texture(const GltfFile &file, const Json &info, ColorSpace space, int channel, const std::string &where,
                      Maps &maps, std::vector<std::string> &warnings) {
    const Json &source = gltf_element(file, "textures", gltf_index(info, "index", where));
    scene::Texture texture;
    texture.channel = channel;
    const int image = gltf_index(source, "source", where);
    if (image < 0) input_error(where, "its texture has no image of a format that plain glTF knows (PNG or JPEG)");
    texture.image = load_image(file, image, space, maps);
    read_transform(info, where, texture, warnings);
    if (gltf_index(info, "texCoord", where) > 0) warnings.push_back(where + ": only the first set of uvs is used");
    if (const int sampler = gltf_index(source, "sampler", where); sampler >= 0) {
        const Json &wrap = gltf_element(file, "samplers", sampler);
        for (const char *name : {"wrapS", "wrapT"})
            if (gltf_number(wrap, name, TINYGLTF_TEXTURE_WRAP_REPEAT, where) != TINYGLTF_TEXTURE_WRAP_REPEAT)
                warnings.push_back(where + ": textures repeat, whatever " + name + " says");
    }
    return maps.add(texture, channel >= 0);
}

} // namespace nacre::io
