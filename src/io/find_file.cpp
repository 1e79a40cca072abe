#include "io/find_file.h"
#include "base/error.h"
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

namespace nacre::io {

namespace fs = std::filesystem;

namespace {

bool is_file(const fs::path &path) {
    std::error_code ignored; // an over-long or odd name is a file that is not there
    return fs::exists(path, ignored) && !fs::is_directory(path, ignored);
}

} // namespace

fs::path find_file(const fs::path &scene, const std::string &name, std::string &looked) {
    looked.clear();
    if (name.empty()) return {};
    const auto try_folder = [&](const fs::path &folder) {
        looked += (looked.empty() ? "" : ", ") + folder.string();
        return is_file(folder / name);
    };
    if (fs::path(name).is_absolute()) return try_folder("/") ? fs::path(name) : fs::path();

    const fs::path beside = scene.parent_path().empty() ? fs::path(".") : scene.parent_path();
    if (try_folder(beside)) return beside / name;
    const char *assets = std::getenv("NACRE_ASSETS");
    std::istringstream folders(assets ? assets : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (!folder.empty() && try_folder(folder)) return fs::path(folder) / name;
    if (!assets) looked += " (NACRE_ASSETS is not set)";
    return {};
}

fs::path find_file(const Source &source, const std::string &path, const std::string &name) {
    std::string looked;
    const fs::path file = find_file(source.file, name, looked);
    if (file.empty())
        throw MissingFile(source.subject(path),
                          fmt::format("{}: there is no file '{}', looked in {}", path, name, looked));
    return file;
}

std::string read_file(const fs::path &file) {
    std::error_code ignored;
    if (fs::is_directory(file, ignored)) input_error(file.string(), "is a folder, not a file");
    std::ifstream stream(file, std::ios::binary);
    if (!stream) input_error(file.string(), "cannot be read: {}", std::strerror(errno));
    std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    if (stream.bad()) input_error(file.string(), "cannot be read: {}", std::strerror(errno));
    return bytes;
}

} // namespace nacre::io
