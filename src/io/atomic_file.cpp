#include "io/atomic_file.h"
#include "base/error.h"
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>
#include <utility>

namespace nacre::io {
namespace fs = std::filesystem;
namespace {

fs::path folder_of(const fs::path &file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

} // namespace

AtomicFile::AtomicFile(const fs::path &target) : file(target) {
    std::error_code error;
    if (fs::is_symlink(file, error)) file = fs::weakly_canonical(file, error);
    if (fs::is_directory(file, error)) fail(EISDIR);
    static std::atomic<unsigned> count{0};
    // O_EXCL: another program's temporary file is never ours. A stale one of a killed process only costs a number.
    do {
        temporary = folder_of(file) / fmt::format(".{}.{}-{}.tmp", file.filename().string(), getpid(), count++);
        descriptor = open(temporary.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    } while (descriptor < 0 && errno == EEXIST);
    if (descriptor < 0) fail(errno);
}

AtomicFile::~AtomicFile() {
    if (descriptor >= 0) close(descriptor);
    if (!temporary.empty()) unlink(temporary.c_str());
}

void AtomicFile::write(const void *bytes, std::size_t size, std::size_t position) {
    const char *next = static_cast<const char *>(bytes);
    while (size > 0) {
        const ssize_t written = pwrite(descriptor, next, size, off_t(position));
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail(errno);
        next += written;
        size -= std::size_t(written);
        position += std::size_t(written);
    }
}

void AtomicFile::commit() {
    if (fsync(descriptor) != 0) fail(errno);
    // Some network file systems report a full disk only here.
    if (close(std::exchange(descriptor, -1)) != 0) fail(errno);
    if (rename(temporary.c_str(), file.c_str()) != 0) fail(errno);
    temporary.clear();
    // The name lasts only once the folder is on the disk too. Where folders cannot be flushed that is the best there
    // is.
    const int folder = open(folder_of(file).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0) return;
    const int error = fsync(folder) == 0 ? 0 : errno;
    close(folder);
    if (error == EIO || error == ENOSPC || error == EDQUOT) fail(error);
}

void AtomicFile::fail(int error) const {
    const std::string folder = folder_of(file).string();
    const auto message = [&]() -> std::string {
        switch (error) {
        case ENOENT:
        case ENOTDIR: return fmt::format("there is no folder {}: create it or choose another output", folder);
        case EISDIR: return "is a folder: name a file in it";
        case EACCES:
        case EPERM:
        case EROFS: return fmt::format("the folder {} is not writable: choose another output", folder);
        case ENOSPC:
        case EDQUOT: return "the disk is full: free some space or choose another output";
        case EFBIG: return "larger than this disk or this user's limit allows: choose another output";
        case ENAMETOOLONG: return "the name is too long: choose a shorter one";
        default: return std::strerror(error);
        }
    }();
    throw Error(Exit::output, file.string(), "cannot be written, " + message);
}

void write_text(const std::filesystem::path &name, const std::string &text) {
    AtomicFile file(name);
    file.write(text.data(), text.size(), 0);
    file.commit();
}

} // namespace nacre::io
