#include "app/albedo_options.h"
#include "base/error.h"
#include "io/read_material.h"
#include <charconv>

namespace nacre::app {
namespace {

/// One number, or three separated by commas, as JSON.
io::Json numbers(const std::string &option, const std::string &text) {
    std::vector<double> values;
    const char *at = text.data(), *end = at + text.size();
    while (at <= end) {
        double value = 0;
        const auto [next, failure] = std::from_chars(at, end, value);
        if (failure != std::errc() || (next != end && *next != ',') || values.size() == 3) {
            values.clear();
            break;
        }
        values.push_back(value);
        at = next + 1;
    }
    if (values.size() != 1 && values.size() != 3)
        throw Error(Exit::usage, option + " " + text, "is neither one number nor three, as in 0.8,0.5,0.4");
    return values.size() == 1 ? io::Json(values[0]) : io::Json(values);
}

} // namespace

void AlbedoOptions::add_medium_to(CLI::App &command) {
    command.add_option("--g", g, "Anisotropy of the phase function, one or one per channel (default 0)")
        ->type_name("G[,G,G]");
    command.add_option("--bleed", bleed, "Non-exponential flights (default 0: exponential)");
    command.add_option("--flight", flight, "renewal (default) or reciprocal");
    command.add_option("--entry", entry, "lambert (default), uniform or refracted");
    command.add_option("--inversion", inversion, "table (default), memo, van_de_hulst, chiang or none");
    command.add_option("--max-depth", max_depth,
                       "Scatters that a walk may have (default 0: no cap; the memo's is 256)");
}

void AlbedoOptions::add_device_to(CLI::App &command) {
    command.add_option("--device", device, "OpenCL device: index, cpu, gpu, or part of its name (see `nacre devices`)");
    command.add_flag("--quiet", quiet, "No progress");
}

scene::Material AlbedoOptions::material() const {
    io::Json tree = {{"subsurface_weight", 1},           {"subsurface_scatter_anisotropy", numbers("--g", g)},
                     {"subsurface_bleed", bleed},        {"subsurface_flight", flight},
                     {"subsurface_entry", entry},        {"subsurface_inversion", inversion},
                     {"subsurface_max_depth", max_depth}};
    if (!color.empty()) tree["subsurface_color"] = numbers("--color", color);
    scene::Scene scene;
    io::Maps maps(scene);
    const io::Source source{"nacre albedo"};
    scene::Material material;
    try {
        io::read_material(tree, "", source, maps, material);
    } catch (const Error &error) {
        throw Error(Exit::usage, "", error.what());
    }
    return material;
}

} // namespace nacre::app
