#pragma once
#include "io/image.h"
#include "scene/scene.h"
#include <filesystem>
#include <map>
#include <span>
#include <string>

namespace nacre::io {

/// The images of a scene: each file is read once per colour space, however many materials name it.
class Maps {
  public:
    explicit Maps(scene::Scene &scene) : scene(scene) {}

    /// Index in Scene::images. Throws Error{Exit::input} naming the file.
    std::uint32_t load(const std::filesystem::path &file, ColorSpace space);

    /// The same for bytes inside another file; `name` is unique and for messages.
    std::uint32_t decode(std::span<const unsigned char> bytes, const std::string &name, ColorSpace space);

    /// Adds `texture` to Scene::textures, returns its index. `numeric`: one channel of the image is the number.
    int add(scene::Texture texture, bool numeric);

  private:
    std::uint32_t keep(const std::string &key, scene::Image image);

    scene::Scene &scene;
    std::map<std::string, std::uint32_t> known; // by name and colour space
};

} // namespace nacre::io
