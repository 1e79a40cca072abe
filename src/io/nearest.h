#pragma once
#include <span>
#include <string>

namespace nacre::io {

/// ", did you mean 'x'?" where one of `known` is close to `name`, else "; known: a, b, c" ("" where there is none).
std::string suggest(const std::string &name, std::span<const std::string> known);

} // namespace nacre::io
