#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace nacre::device {

/// What the compiler gets, in `folder`, which is made if it is not there: the source, below one comment line with the
/// options, as the file `entry` ("render.cl"), and options.txt. Throws Error{Exit::output}.
void dump_source(const std::filesystem::path &folder, const std::string &entry, const std::string &source,
                 const std::string &options);

/// What it made of that: `entry` with the ending .bin, and build.log, which may be empty. Throws Error{Exit::output}.
void dump_result(const std::filesystem::path &folder, const std::string &entry,
                 const std::vector<unsigned char> &binary, const std::string &log);

} // namespace nacre::device
