#include "device/dump.h"
#include "base/error.h"
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string_view>

namespace fs = std::filesystem;

namespace nacre::device {
namespace {

void write(const fs::path &name, std::string_view bytes) {
    errno = 0;
    std::ofstream file(name, std::ios::binary);
    file.write(bytes.data(), std::streamsize(bytes.size()));
    file.close();
    if (!file)
        throw Error(Exit::output, name.string(),
                    fmt::format("cannot be written ({}); choose another folder for --dump-kernel",
                                errno ? std::strerror(errno) : "unknown reason"));
}

} // namespace

void dump_source(const fs::path &folder, const std::string &entry, const std::string &source,
                 const std::string &options) {
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure)
        throw Error(
            Exit::output, folder.string(),
            fmt::format("this folder cannot be made ({}); choose another one for --dump-kernel", failure.message()));
    write(folder / entry, "// compile with: " + options + "\n" + source);
    write(folder / "options.txt", options + "\n");
}

void dump_result(const fs::path &folder, const std::string &entry, const std::vector<unsigned char> &binary,
                 const std::string &log) {
    write(folder / fs::path(entry).replace_extension(".bin"),
          {reinterpret_cast<const char *>(binary.data()), binary.size()});
    write(folder / "build.log", log);
}

} // namespace nacre::device
