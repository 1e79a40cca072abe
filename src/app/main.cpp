#include "app/commands.h"
#include "base/error.h"
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

namespace {

constexpr const char *examples = R"(Examples:
  nacre render scenes/bear/bear.json -o bear.png
  nacre render head.glb -o head.exr --spp 256 --size 1024x1024
  nacre render scene.json -o out.exr --set materials.skin.subsurface_bleed=0.5 --aov albedo,N
  nacre render scenes/bear/bear.json -o bear.png --set materials.gummy.subsurface_model=burley
  nacre check scene.json
  nacre profile scene.json --size 256x256
  nacre sheet scenes/figures/figure5.json -o figure5.png
  nacre albedo --color 0.8,0.5,0.4 --g 0.8
  nacre compare new.exr reference.exr --heatmap where.png
  nacre devices

Exit codes: 0 done, 1 the render failed or the pictures differ, 2 bad command line, 3 bad scene or input file, 4 no device
or device failure, 5 output cannot be written, 130 interrupted (what was rendered is saved).)";

int complain(const std::string &message, nacre::Exit code) {
    fmt::print(stderr, "nacre: error: {}\n", message);
    return int(code);
}

int run(int argc, char **argv) {
    CLI::App program{"nacre renders subsurface scattering by path tracing, on any OpenCL device.", "nacre"};
    program.footer(examples);
    program.require_subcommand(1);
    program.set_version_flag("--version", NACRE_VERSION);
    using namespace nacre::app;
    const Run commands[] = {add_render(program), add_devices(program), add_check(program),  add_profile(program),
                            add_sheet(program),  add_albedo(program),  add_compare(program)};
    const std::vector<CLI::App *> known = program.get_subcommands({});
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError &error) {
        if (error.get_exit_code() == 0) return program.exit(error); // --help, --version
        return complain(fmt::format("{}; see `nacre --help`", error.what()), nacre::Exit::usage);
    }
    for (std::size_t i = 0; i < known.size(); ++i)
        if (known[i]->parsed()) return commands[i]();
    return int(nacre::Exit::usage);
}

} // namespace

int main(int argc, char **argv) {
    std::signal(SIGXFSZ, SIG_IGN); // a limit on file sizes is then an error of the write, and reported
    try {
        return run(argc, argv);
    } catch (const nacre::Error &error) {
        return complain(error.what(), error.code);
    } catch (const std::bad_alloc &) {
        return complain("out of memory; use a smaller scene or image", nacre::Exit::failed);
    } catch (const std::exception &error) {
        return complain(error.what(), nacre::Exit::failed);
    }
}
