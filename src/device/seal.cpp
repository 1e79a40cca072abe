#include "device/seal.h"
#include <fmt/format.h>
#include <fstream>
#include <map>
#include <vector>
#include <xxhash.h>

namespace fs = std::filesystem;

namespace nacre::device {
namespace {

constexpr const char *seal_name = "nacre.sums";

using Sums = std::map<std::string, std::string>; // file relative to the program's folder -> checksum of its bytes

std::vector<fs::path> programs(const fs::path &folder) {
    std::vector<fs::path> found;
    std::error_code ignored;
    for (const auto &prefix : fs::directory_iterator(folder, ignored))
        if (prefix.is_directory(ignored) && prefix.path().filename().string().size() == 2)
            for (const auto &program : fs::directory_iterator(prefix, ignored)) found.push_back(program.path());
    return found;
}

std::string checksum(const fs::path &file) {
    std::ifstream stream(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    return fmt::format("{:016x}", XXH3_64bits(bytes.data(), bytes.size()));
}

/// Bitcode and machine code: what PoCL would load.
std::vector<fs::path> current_files(const fs::path &program) {
    std::vector<fs::path> files;
    std::error_code ignored;
    for (const auto &entry : fs::recursive_directory_iterator(program, ignored)) {
        const std::string extension = entry.path().extension().string();
        if (extension == ".bc" || extension == ".so") files.push_back(entry.path());
    }
    return files;
}

Sums sealed_sums(const fs::path &program) {
    Sums sums;
    std::ifstream seal(program / seal_name);
    for (std::string sum, name; seal >> sum && std::getline(seal >> std::ws, name);) sums[name] = sum;
    return sums;
}

} // namespace

void seal_programs(const fs::path &folder) {
    for (const fs::path &program : programs(folder)) {
        const std::vector<fs::path> files = current_files(program);
        // Nothing was added since. Reading them all would take longer than the rest of a start: a third of a second.
        if (files.size() == sealed_sums(program).size()) continue;
        const fs::path temporary = program / (std::string(seal_name) + ".new");
        std::ofstream seal(temporary);
        std::error_code ignored;
        for (const fs::path &file : files)
            seal << checksum(file) << ' ' << fs::relative(file, program, ignored).string() << '\n';
        seal.close();
        if (seal) fs::rename(temporary, program / seal_name, ignored);
    }
}

void drop_broken_programs(const fs::path &folder) {
    for (const fs::path &program : programs(folder))
        for (const auto &[name, sum] : sealed_sums(program)) {
            std::error_code ignored;
            // A file that is missing is no harm, PoCL makes it again; so is one that was added and not sealed yet.
            if (!fs::exists(program / name, ignored) || checksum(program / name) == sum) continue;
            fs::remove_all(program, ignored);
            break;
        }
}

} // namespace nacre::device
