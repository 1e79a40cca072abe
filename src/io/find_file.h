#pragma once
#include "io/source.h"
#include <filesystem>
#include <string>

namespace nacre::io {

/// The file that `scene` calls `name`: absolute, or beside the scene, or in a folder of NACRE_ASSETS (':' separated).
/// Returns an empty path where there is none and says in `looked` where it was looked for.
std::filesystem::path find_file(const std::filesystem::path &scene, const std::string &name, std::string &looked);

/// The same for what the field at `path` calls `name`; throws MissingFile where there is none.
std::filesystem::path find_file(const Source &source, const std::string &path, const std::string &name);

/// The bytes of `file`. Throws Error{Exit::input}.
std::string read_file(const std::filesystem::path &file);

} // namespace nacre::io
