#pragma once
#include <filesystem>

namespace nacre::app {

/// Finds out before the work, and not after, that the picture could not be written. Throws Error{Exit::output};
/// Error{Exit::usage} for an ending that is neither .exr nor .png.
void check_output(const std::filesystem::path &file);

/// The same for a file of any kind.
void check_output_file(const std::filesystem::path &file);

/// The same for a folder that files go into.
void check_output_folder(const std::filesystem::path &folder, const std::string &subject);

} // namespace nacre::app
