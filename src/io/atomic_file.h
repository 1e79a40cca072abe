#pragma once
#include <cstddef>
#include <filesystem>
#include <string>

namespace nacre::io {

/// A file that appears whole or not at all: bytes go to a temporary file beside it, `commit` flushes that to the disk
/// and renames it. Without a commit (an exception on the way) the temporary file is removed and what was there stays.
/// Everything throws Error{Exit::output}, which says why and what to do.
class AtomicFile {
  public:
    /// A symbolic link is followed: the file it points at is replaced, not the link.
    explicit AtomicFile(const std::filesystem::path &file);
    ~AtomicFile();
    AtomicFile(const AtomicFile &) = delete;
    AtomicFile &operator=(const AtomicFile &) = delete;

    void write(const void *bytes, std::size_t size, std::size_t position);
    void commit();

  private:
    [[noreturn]] void fail(int error) const;

    std::filesystem::path file, temporary;
    int descriptor = -1;
};

/// Writes a whole AtomicFile.
void write_text(const std::filesystem::path &name, const std::string &text);

} // namespace nacre::io
