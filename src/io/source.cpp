#include "io/source.h"
#include "base/error.h"
#include <algorithm>

namespace nacre::io {

void Source::fail(const std::string &path, const std::string &message) const {
    const bool set = std::any_of(overridden.begin(), overridden.end(), [&](const std::string &prefix) {
        return path.starts_with(prefix) && (path.size() == prefix.size() || path[prefix.size()] == '.');
    });
    throw Error(Exit::input, set ? "--set" : file.string(), path.empty() ? message : path + ": " + message);
}

std::string join(const std::string &path, const std::string &name) { return path.empty() ? name : path + "." + name; }

} // namespace nacre::io
