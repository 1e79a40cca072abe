#include "device/cache.h"
#include "device/seal.h"
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <mutex>
#include <signal.h>
#include <unistd.h>
#include <xxhash.h>

namespace fs = std::filesystem;

namespace nacre::device {
namespace {

bool writable(const fs::path &folder) {
    std::error_code ignored;
    fs::create_directories(folder, ignored);
    return access(folder.c_str(), W_OK | X_OK) == 0;
}

fs::path choose_cache_folder() {
    const char *xdg = std::getenv("XDG_CACHE_HOME"), *home = std::getenv("HOME");
    if (xdg && *xdg && writable(fs::path(xdg) / "nacre")) return fs::path(xdg) / "nacre";
    if (home && *home && writable(fs::path(home) / ".cache" / "nacre")) return fs::path(home) / ".cache" / "nacre";
    const fs::path temporary = fs::temp_directory_path() / fmt::format("nacre-{}", getuid());
    writable(temporary);
    return temporary;
}

fs::path pocl_folder() { return cache_folder() / "pocl"; }
fs::path marker(pid_t process) { return cache_folder() / fmt::format("compiling.{}", process); }

bool died_compiling(const fs::path &file) {
    const std::string name = file.filename().string();
    if (name.rfind("compiling.", 0) != 0) return false;
    const long process = std::strtol(name.c_str() + strlen("compiling."), nullptr, 10);
    return process > 0 && process != getpid() && kill(pid_t(process), 0) != 0;
}

struct BinaryHeader {
    char magic[8] = {'n', 'a', 'c', 'r', 'e', 'b', 'i', 'n'};
    XXH64_hash_t checksum = 0;
};

} // namespace

const fs::path &cache_folder() {
    static const fs::path folder = choose_cache_folder();
    return folder;
}

void prepare_pocl_cache() {
    std::error_code ignored;
    drop_broken_programs(pocl_folder());
    for (const auto &entry : fs::directory_iterator(cache_folder(), ignored))
        if (died_compiling(entry.path())) {
            wipe_pocl_cache();
            fs::remove(entry.path(), ignored);
        }
    fs::create_directories(pocl_folder(), ignored);
    setenv("POCL_CACHE_DIR", pocl_folder().c_str(), 0);
}

void begin_compiling() {
    static std::once_flag once;
    std::call_once(once, [] { std::atexit(finish_compiling); });
    std::ofstream(marker(getpid())).put('\n');
}

void finish_compiling() {
    std::error_code ignored;
    if (fs::remove(marker(getpid()), ignored)) seal_programs(pocl_folder());
}

void wipe_pocl_cache() {
    std::error_code ignored;
    fs::remove_all(pocl_folder(), ignored);
    fs::create_directories(pocl_folder(), ignored);
}

std::optional<std::vector<unsigned char>> load_binary(const std::string &key) {
    std::ifstream file(cache_folder() / (key + ".bin"), std::ios::binary);
    BinaryHeader header;
    if (!file.read(reinterpret_cast<char *>(&header), sizeof header)) return {};
    std::vector<unsigned char> binary{std::istreambuf_iterator<char>(file), {}};
    if (memcmp(header.magic, BinaryHeader{}.magic, sizeof header.magic) != 0 ||
        header.checksum != XXH3_64bits(binary.data(), binary.size()))
        return {};
    return binary;
}

void store_binary(const std::string &key, const std::vector<unsigned char> &binary) {
    // The cache only saves time: a full disk is no error. The rename keeps a half-written entry from ever being read.
    const fs::path temporary = cache_folder() / fmt::format("{}.{}", key, getpid());
    std::ofstream file(temporary, std::ios::binary);
    BinaryHeader header;
    header.checksum = XXH3_64bits(binary.data(), binary.size());
    file.write(reinterpret_cast<const char *>(&header), sizeof header);
    file.write(reinterpret_cast<const char *>(binary.data()), std::streamsize(binary.size()));
    file.close();
    std::error_code ignored;
    if (file)
        fs::rename(temporary, cache_folder() / (key + ".bin"), ignored);
    else
        fs::remove(temporary, ignored);
}

} // namespace nacre::device
