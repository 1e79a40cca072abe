#include "albedo/half_space.h"
#include "albedo/inversion.h"
#include "app/albedo_commands.h"
#include "app/progress.h"
#include "base/error.h"
#include "patch/patch.h"
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

namespace nacre::app {
namespace {

using namespace shared;
using Three = std::array<double, 3>;

/// What becomes of a colour that is asked for.
struct Answer {
    Three color, albedo, expected; // expected: by the solver, for walks without a cap
    patch::Color measured;         // with --check
};

Answer answer(const AlbedoOptions &options, const scene::Material &material) {
    Answer answer{};
    std::map<double, albedo::HalfSpace> media; // by g: a second each
    for (std::size_t c = 0; c < 3; ++c) {
        const double g = material[PARAMETER_subsurface_scatter_anisotropy].value[Eigen::Index(c)];
        answer.color[c] = material[PARAMETER_subsurface_color].value[Eigen::Index(c)];
        answer.albedo[c] = albedo::albedo(
            material.inversion, answer.color[c],
            {.anisotropy = g, .bleed = options.bleed, .flight = material.flight, .entry = material.entry});
        const albedo::HalfSpace &medium =
            media.try_emplace(g, g, std::min(options.bleed, 4.0), material.flight).first->second;
        answer.expected[c] =
            medium.color(std::sqrt((1 - answer.albedo[c]) / (1 - g * answer.albedo[c])), material.entry);
    }
    if (options.check) {
        ProgressBar bar(options.quiet);
        answer.measured = patch::measure(options.open_device(), material, options.error,
                                         [&](double share) { bar.show(share, "patch"); });
        bar.finish();
    }
    return answer;
}

void print_json(const AlbedoOptions &options, const Answer &answer) {
    nlohmann::ordered_json document = {{"color", answer.color},   {"g", options.g},
                                       {"bleed", options.bleed},  {"flight", options.flight},
                                       {"entry", options.entry},  {"inversion", options.inversion},
                                       {"albedo", answer.albedo}, {"expected_color", answer.expected}};
    if (options.check) {
        document["measured_color"] = answer.measured.value;
        document["standard_error"] = answer.measured.error;
    }
    fmt::print("{}\n", document.dump(2));
}

void print_lines(const AlbedoOptions &options, const Answer &answer) {
    const auto line = [](const char *name, const Three &values, const char *format) {
        fmt::print("{:<16}", name);
        for (const double value : values) fmt::print(fmt::runtime(format), value);
        fmt::print("\n");
    };
    Three error, z;
    for (std::size_t c = 0; c < 3; ++c) error[c] = answer.expected[c] - answer.color[c];
    line("color asked", answer.color, "{:>12.6f}");
    line("albedo", answer.albedo, "{:>12.8f}");
    line("color expected", answer.expected, "{:>12.6f}");
    line("error", error, "{:>12.1e}");
    if (!options.check) return;
    for (std::size_t c = 0; c < 3; ++c)
        z[c] = (answer.measured.value[c] - answer.expected[c]) / std::max(answer.measured.error[c], 1e-12);
    line("color measured", answer.measured.value, "{:>12.6f}");
    line("standard error", answer.measured.error, "{:>12.1e}");
    line("z to expected", z, "{:>12.1f}");
}

int run(const AlbedoOptions &options) {
    if (options.color.empty()) throw Error(Exit::usage, "--color", "is missing, as in --color 0.8,0.5,0.4");
    const scene::Material material = options.material();
    const Answer found = answer(options, material);
    options.as_json ? print_json(options, found) : print_lines(options, found);
    return int(Exit::done);
}

} // namespace

Run add_albedo(CLI::App &program) {
    CLI::App *command = program.add_subcommand(
        "albedo", "Say which single-scattering albedo gives a surface colour, and what colour comes of it.");
    const auto options = std::make_shared<AlbedoOptions>();
    command->add_option("--color", options->color, "Surface colour, linear: one number or three")->type_name("R,G,B");
    options->add_medium_to(*command);
    command->add_flag("--check", options->check, "Render a patch, too, and print the colour that it shows");
    command->add_option("--error", options->error, "Standard error of the patch (default 0.001)")
        ->check(CLI::Range(1e-5, 0.1));
    options->add_device_to(*command);
    command->add_flag("--json", options->as_json, "Print JSON");
    command->require_subcommand(0, 1);
    const Run others[] = {add_albedo_chart(*command), add_albedo_build(*command), add_albedo_fit(*command)};
    command->footer("\"expected\" is the colour of a half-space by discrete ordinates, without random numbers,\n"
                    "for a bleed of 4 at most; a cap on scatters and refraction at the surface are not in it.\n\n"
                    "Examples:\n"
                    "  nacre albedo --color 0.8,0.5,0.4 --g 0.8 --bleed 0.5\n"
                    "  nacre albedo --color 0.8 --g 0.8 --inversion van_de_hulst\n"
                    "  nacre albedo --color 0.8,0.5,0.4 --g 0.8 --check --error 1e-4\n"
                    "  nacre albedo chart -o chart.png --g 0.8");
    const std::vector<CLI::App *> known = command->get_subcommands({});
    return [=, others = std::vector(std::begin(others), std::end(others))] {
        for (std::size_t i = 0; i < known.size(); ++i)
            if (known[i]->parsed()) return others[i]();
        return run(*options);
    };
}

} // namespace nacre::app
