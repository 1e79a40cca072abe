#include "scene/check.h"
#include "app/commands.h"
#include "app/scene_options.h"
#include <fmt/format.h>

namespace nacre::app {

Run add_check(CLI::App &program) {
    CLI::App *command = program.add_subcommand(
        "check",
        "Say what may be wrong with a scene: open meshes, inverted normals, a mean free path out of proportion, what "
        "is ignored.");
    const auto options = std::make_shared<SceneOptions>();
    options->add_to(*command);
    return [options] {
        const scene::Scene scene = io::load_scene(options->file, options->overrides());
        const auto findings = scene::check(scene);
        for (const scene::Finding &finding : findings) fmt::print("{}: {}\n", finding.subject, finding.text);
        if (findings.empty()) fmt::print("{}: nothing to remark\n", options->file);
        return 0;
    };
}

} // namespace nacre::app
