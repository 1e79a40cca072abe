#include "device/source.h"
#include "base/error.h"
#include <fstream>
#include <iomanip>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

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

std::string located(const std::string &log, const std::string &source) {
    std::vector<std::string> places{""}; // of line n
    std::istringstream lines(source);
    std::string name;
    int number = 0;
    for (std::string line; std::getline(lines, line); ++number) {
        places.push_back(fmt::format("{}:{}:", name, number));
        if (line.rfind("#line ", 0) != 0) continue;
        std::istringstream(line.substr(6)) >> number >> std::quoted(name);
        --number; // it is of the next line
    }
    static const std::regex counted("<kernel>:([0-9]+):");
    std::string out;
    std::size_t end = 0;
    for (std::sregex_iterator found(log.begin(), log.end(), counted), none; found != none; ++found) {
        out.append(log, end, std::size_t(found->position()) - end);
        const std::size_t line = std::stoul(found->str(1));
        out += line < places.size() ? places[line] : found->str();
        end = std::size_t(found->position() + found->length());
    }
    return out.append(log, end);
}

} // namespace nacre::device
