#include "device/source.h"
#include "base/error.h"
#include <fstream>
#include <set>
#include <sstream>

namespace nacre::device {
namespace {

std::string read(const std::string &name, const std::filesystem::path &folder) {
    if (folder.empty()) {
        const auto &files = embedded_kernels();
        const auto file = files.find(name);
        if (file == files.end()) throw Error(Exit::device, name, "no such kernel file in this program");
        return std::string(file->second);
    }
    std::ifstream file(folder / name, std::ios::binary);
    if (!file) throw Error(Exit::device, (folder / name).string(), "cannot read this kernel file; check --kernels");
    return {std::istreambuf_iterator<char>(file), {}};
}

void expand(const std::string &name, const std::filesystem::path &folder, std::set<std::string> &seen,
            std::string &out) {
    if (!seen.insert(name).second) return;
    std::istringstream text(read(name, folder));
    out += fmt::format("#line 1 \"{}\"\n", name);
    int number = 0;
    for (std::string line; std::getline(text, line);) {
        ++number;
        const std::string directive = "#include \"";
        if (line.rfind(directive, 0) == 0) {
            expand(line.substr(directive.size(), line.rfind('"') - directive.size()), folder, seen, out);
            out += fmt::format("#line {} \"{}\"\n", number + 1, name);
        } else {
            out += line + '\n';
        }
    }
}

} // namespace

std::string assemble(const std::string &entry, const std::filesystem::path &folder) {
    std::set<std::string> seen;
    std::string out;
    expand(entry, folder, seen, out);
    return out;
}

} // namespace nacre::device
