// What compilers see of the kernels: without -DPROFILE as if nothing had ever been counted for a profile, and nothing
// that some of them do not take.
#include "device/program.h"
#include "device/source.h"
#include "shared/features.h"
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <regex>
#include <sstream>
#include <unistd.h>

namespace nacre::device {
namespace {

namespace fs = std::filesystem;

/// `text` without NAME(…), its parentheses balanced.
std::string without_calls(std::string text, const std::string &name) {
    for (std::size_t at; (at = text.find(name + '(')) != std::string::npos;) {
        std::size_t end = at + name.size();
        int depth = 0;
        do depth += text.at(end) == '(' ? 1 : text.at(end) == ')' ? -1 : 0;
        while (++end, depth > 0);
        text.erase(at, end - at);
    }
    return text;
}

/// `source` without its blocks of #if … PROFILE, without PROFILED(…) and its kin.
std::string stripped(const std::string &source) {
    std::istringstream lines(source);
    std::string out;
    int depth = 0; // of #if inside such a block, itself counted
    for (std::string line; std::getline(lines, line);) {
        const bool opens = line.rfind("#if", 0) == 0, closes = line.rfind("#endif", 0) == 0;
        const bool about_it = line.rfind("#ifdef PROFILE", 0) == 0 || line.rfind("#if defined(PROFILE)", 0) == 0;
        const bool definition = line.rfind("#define COUNT_PROFILE", 0) == 0 || line.rfind("#define COUNT_WALK", 0) == 0;
        if (opens && (depth > 0 || about_it)) ++depth;
        if (depth == 0 && !definition) out += line + '\n';
        if (closes && depth > 0) --depth;
    }
    for (const char *name : {"COUNT_PROFILE", "COUNT_WALK", "AND_PROFILED", "PROFILED"}) out = without_calls(out, name);
    return out;
}

/// What the preprocessor leaves of it: its words and signs, one space between those that had any.
std::string preprocessed(const std::string &source, const std::string &options) {
    const fs::path in = fs::temp_directory_path() / fmt::format("nacre-profile-{}.c", getpid());
    const fs::path out = fs::path(in).replace_extension(".i");
    std::ofstream(in) << source;
    const std::string command = fmt::format("{} -E -P -x c -D__OPENCL_C_VERSION__=120 {} {} -o {}", NACRE_COMPILER,
                                            options, in.string(), out.string());
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    std::ifstream file(out);
    std::string text;
    for (std::string word; file >> word;) text += word + ' ';
    fs::remove(in);
    fs::remove(out);
    return text;
}

/// -D options alone.
std::string definitions(const Variant &variant) {
    std::string options = device::options(Device(), variant);
    return options.substr(options.find("-D"));
}

TEST(ProfileSource, NothingIsLeftWithoutIt) {
    const std::string source = assemble("render.cl");
    for (const bool generic : {false, true})
        for (const std::uint32_t features :
             {std::uint32_t(shared::FEATURE_SUBSURFACE), std::uint32_t(shared::FEATURE_ALL)})
            for (const int lanes : {1, 8}) {
                Variant variant;
                variant.features = features;
                variant.generic = generic;
                variant.lanes = lanes;
                const std::string options = definitions(variant), plain = preprocessed(source, options);
                ASSERT_GT(plain.size(), 10000u);
                EXPECT_EQ(plain, preprocessed(stripped(source), options)) << options;
                variant.profile = true;
                EXPECT_NE(plain, preprocessed(source, definitions(variant))) << options;
            }
}

/// OpenCL C 1.2 has none. Most compilers take them, NVIDIA's does not.
TEST(KernelSource, HasNoVariadicMacros) {
    static const std::regex variadic("#define \\w+\\([^)\n]*\\.\\.\\.");
    for (const char *entry : {"render.cl", "probe.cl", "probe_lanes.cl", "probe_guide.cl", "probe_clearance.cl"}) {
        const std::string source = assemble(entry);
        ASSERT_GT(source.size(), 10000u) << entry;
        EXPECT_FALSE(std::regex_search(source, variadic)) << entry;
    }
    EXPECT_TRUE(std::regex_search("a\n#define B(...) c\n", variadic));
}

TEST(ProfileSource, StrippingTakesAllOfIt) {
    const std::string text =
        stripped("a;\n#ifdef PROFILE\n#ifdef x\nb;\n#endif\nc;\n#else\nd;\n#endif\n#ifdef y\ne;\n#endif\n"
                 "COUNT_PROFILE(counts, walk_nodes, f(g(1), 2))\nh(i AND_PROFILED(&j[(k)]));\n"
                 "#if defined(PROFILE) || !defined(z)\nl;\n#endif\nCOUNT_WALK(m, n)\no;\n");
    EXPECT_EQ(text, "a;\n#ifdef y\ne;\n#endif\n\nh(i );\n\no;\n");
}

} // namespace
} // namespace nacre::device
