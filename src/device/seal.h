#pragma once
#include <filesystem>

namespace nacre::device {

/// PoCL keeps a folder for each program, FOLDER/xx/HASH/, and loads what lies there unseen. `seal_programs` writes
/// checksums of the files beside those that have none yet; `drop_broken_programs` removes the programs that do not
/// match theirs.
void seal_programs(const std::filesystem::path &folder);
void drop_broken_programs(const std::filesystem::path &folder);

} // namespace nacre::device
