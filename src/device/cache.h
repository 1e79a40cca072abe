#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace nacre::device {

/// $XDG_CACHE_HOME/nacre or ~/.cache/nacre; a folder in the temporary directory where neither can be written.
const std::filesystem::path &cache_folder();

/// Points PoCL at a private cache below cache_folder() (unless the user has set POCL_CACHE_DIR). Call before the first
/// OpenCL call. PoCL aborts on a broken entry: programs whose files are not what they were are removed, and everything
/// is if a process died while compiling.
void prepare_pocl_cache();

/// Says that this process may be writing machine code into PoCL's cache, until `finish_compiling` (or its normal end),
/// which takes the checksums of what is new there.
void begin_compiling();
void finish_compiling();

/// Removes everything in PoCL's private cache.
void wipe_pocl_cache();

/// Program binaries by key, each with a checksum: an entry that is broken is as good as none.
std::optional<std::vector<unsigned char>> load_binary(const std::string &key);
void store_binary(const std::string &key, const std::vector<unsigned char> &binary);

} // namespace nacre::device
