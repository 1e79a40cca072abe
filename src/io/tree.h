#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace nacre::io {

/// JSON in the order of the file (materials keep their order).
using Json = nlohmann::ordered_json;

/// Parses `text`. Throws Error{Exit::input} with line and column; also for a key given twice and for nesting deeper
/// than any scene needs. `subject` is the file, for messages.
Json parse_json(const std::string &text, const std::string &subject);

} // namespace nacre::io
