#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace nacre::device {

/// Every file under kernels/ as it was when the program was built, by its path relative to kernels/.
const std::map<std::string, std::string_view> &embedded_kernels();

/// Kernel text ready for the compiler: `entry` ("render.cl") with every #include "…" replaced by that file, once, and
/// #line marks so that a build log names file and line. Read from `folder`, or from the embedded files if it is empty.
/// Throws Error{Exit::device} when a file is missing.
std::string assemble(const std::string &entry, const std::filesystem::path &folder = {});

/// A build log with file and line of what it says about `source`: NVIDIA's compiler heeds no #line and counts the lines
/// of the whole ("<kernel>:5082:88:").
std::string located(const std::string &log, const std::string &source);

} // namespace nacre::device
