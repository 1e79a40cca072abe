#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace nacre::io {

/// Where a tree of values came from: the scene's file, and the paths that `--set` put in.
struct Source {
    std::filesystem::path file;
    std::vector<std::string> overridden; // "materials.skin.subsurface_radius"

    /// Throws Error{Exit::input}: "FILE: PATH: MESSAGE", or "--set: PATH: MESSAGE" where the value came from there.
    [[noreturn]] void fail(const std::string &path, const std::string &message) const;
};

/// "a.b", or "b" where a is empty.
std::string join(const std::string &path, const std::string &name);

} // namespace nacre::io
