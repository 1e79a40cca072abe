// Whatever is wrong with the cache of machine code, the next render works.
#include "cli/cli.h"
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <sys/stat.h>
#include <thread>

namespace nacre {
namespace {

namespace fs = std::filesystem;

class Cache : public Cli {
  protected:
    Surroundings own{.environment = {{"XDG_CACHE_HOME", path("cache")}}};
    const fs::path pocl = folder / "cache/nacre/pocl";

    // A process's share of a test: a render of its own, from this cache.
    Outcome render(const std::string &name = "out.exr") const { return run(plain(name), own); }
    std::vector<std::string> plain(const std::string &name) const {
        return small_render(ball, name, {"--aov", "none", "--quiet"});
    }

    std::vector<fs::path> entries(std::initializer_list<const char *> endings) const {
        std::vector<fs::path> found;
        for (const auto &entry : fs::recursive_directory_iterator(pocl))
            if (entry.is_regular_file() &&
                std::find(endings.begin(), endings.end(), entry.path().extension().string()) != endings.end())
                found.push_back(entry.path());
        return found;
    }

    void fill() const {
        ASSERT_EQ(render().code, 0);
        ASSERT_FALSE(entries({".so", ".bc"}).empty()) << "nothing was cached in " << pocl;
        fs::remove(folder / "out.exr");
    }

    void expect_renders() const {
        const Outcome outcome = render();
        EXPECT_EQ(outcome.code, 0) << "signal " << outcome.signal << "\n" << outcome.err;
        EXPECT_TRUE(read_picture(folder / "out.exr"));
    }
};

TEST_F(Cache, TruncatedEntries) {
    fill();
    for (const fs::path &file : entries({".so", ".bc"})) fs::resize_file(file, fs::file_size(file) / 2);
    expect_renders();
}

TEST_F(Cache, EmptyEntries) {
    fill();
    for (const fs::path &file : entries({".so", ".bc"})) fs::resize_file(file, 0);
    expect_renders();
}

TEST_F(Cache, Rubbish) {
    fill();
    for (const fs::path &file : entries({".so", ".bc"})) put(file, std::string(fs::file_size(file), 'x'));
    expect_renders();
}

TEST_F(Cache, MissingEntries) {
    fill();
    for (const fs::path &file : entries({".so"})) fs::remove(file);
    expect_renders();
    for (const fs::path &file : entries({".bc"})) fs::remove(file);
    expect_renders();
}

TEST_F(Cache, NotWritable) {
    fs::create_directory(folder / "cache");
    chmod(path("cache").c_str(), 0555);
    own.obey_modes = true;
    own.environment["HOME"] = path("none");
    expect_renders();
    chmod(path("cache").c_str(), 0755);
    EXPECT_TRUE(fs::is_empty(folder / "cache"));
}

TEST_F(Cache, TwoAtOnce) {
    Program first(plain("first.exr"), own), second(plain("second.exr"), own);
    const Outcome a = first.wait(), b = second.wait();
    EXPECT_EQ(a.code, 0) << a.signal << a.err;
    EXPECT_EQ(b.code, 0) << b.signal << b.err;
    EXPECT_EQ(bytes_of(folder / "first.exr").size(), bytes_of(folder / "second.exr").size());
}

// Killed at any moment of compiling, the next one works.
TEST_F(Cache, KilledWhileCompiling) {
    for (const int milliseconds : {150, 400, 700, 1000, 1300}) {
        {
            Program killed(plain("killed.exr"), own);
            std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
            killed.send(SIGKILL);
        }
        SCOPED_TRACE(milliseconds);
        expect_renders();
        fs::remove_all(folder / "cache");
    }
}

} // namespace
} // namespace nacre
