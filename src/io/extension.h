#pragma once
#include <filesystem>
#include <string>

namespace nacre::io {

/// ".obj" for "HEAD.OBJ".
std::string extension_of(const std::filesystem::path &file);

} // namespace nacre::io
