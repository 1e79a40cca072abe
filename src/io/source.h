#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace nacre::io {

/// Where a tree of values came from: the scene's file, and the paths that `--set` (or a panel of a sheet) put in.
struct Source {
    std::filesystem::path file;
    std::vector<std::string> overridden = {}; // "materials.skin.subsurface_radius"
    std::string overrides = "--set";          // what put them in, for messages

    /// Whose fault the value at `path` is: the file, or what put it in.
    std::string subject(const std::string &path) const;
    /// Throws Error{Exit::input}: "FILE: PATH: MESSAGE", or "--set: PATH: MESSAGE" where the value came from there.
    [[noreturn]] void fail(const std::string &path, const std::string &message) const;
};

/// "a.b", or "b" where a is empty.
std::string join(const std::string &path, const std::string &name);

} // namespace nacre::io
