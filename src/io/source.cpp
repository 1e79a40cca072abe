#include "io/source.h"
#include "base/error.h"
#include <algorithm>

namespace nacre::io {

std::string Source::subject(const std::string &path) const {
    const bool set = std::any_of(overridden.begin(), overridden.end(), [&](const std::string &prefix) {
        return path.starts_with(prefix) && (path.size() == prefix.size() || path[prefix.size()] == '.');
    });
    return set ? overrides : file.string();
}

void Source::fail(const std::string &path, const std::string &message) const {
    throw Error(Exit::input, subject(path), path.empty() ? message : path + ": " + message);
}

std::string join(const std::string &path, const std::string &name) { return path.empty() ? name : path + "." + name; }

} // namespace nacre::io
