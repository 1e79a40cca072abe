#pragma once
#include <span>
#include <string>
#include <string_view>

namespace nacre::io {

/// The two chunks of a binary glTF file; views into its bytes.
struct Glb {
    std::string_view json, binary; // binary: empty where there is none
};

/// Takes `bytes` apart. Throws Error{Exit::input} for a header or a chunk that does not fit in them.
Glb split_glb(std::string_view bytes, const std::string &subject);

/// Puts a binary glTF file together.
std::string join_glb(const Glb &parts);

} // namespace nacre::io
