#include "io/maps.h"

namespace nacre::io {

namespace {

std::string key_of(const std::string &name, ColorSpace space) {
    return name + (space == ColorSpace::srgb ? "|srgb" : "|linear");
}

} // namespace

std::uint32_t Maps::keep(const std::string &key, scene::Image image) {
    const auto index = static_cast<std::uint32_t>(scene.images.size());
    scene.images.push_back(std::move(image));
    known.emplace(key, index);
    return index;
}

std::uint32_t Maps::load(const std::filesystem::path &file, ColorSpace space) {
    const std::string key = key_of(std::filesystem::weakly_canonical(file).string(), space);
    const auto found = known.find(key);
    return found != known.end() ? found->second : keep(key, load_texture(file, space));
}

std::uint32_t Maps::decode(std::span<const unsigned char> bytes, const std::string &name, ColorSpace space) {
    const std::string key = key_of(name, space);
    const auto found = known.find(key);
    return found != known.end() ? found->second : keep(key, decode_texture(bytes, name, space));
}

int Maps::add(scene::Texture texture, bool numeric) {
    // A grey image has one channel, which is red, green and blue at once.
    if (numeric && (texture.channel < 0 || scene.images[texture.image].channels == 1)) texture.channel = 0;
    scene.textures.push_back(texture);
    return static_cast<int>(scene.textures.size()) - 1;
}

} // namespace nacre::io
