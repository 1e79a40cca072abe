#include "app/scene_options.h"
#include "base/error.h"

namespace nacre::app {

void SceneOptions::add_to(CLI::App &command) {
    command.add_option("scene", file, "nacre JSON, glTF (.gltf, .glb) or a bare mesh (.obj, .ply)")
        ->required()
        ->type_name("SCENE");
    command
        .add_option("--set", set,
                    "Change the scene: PATH=VALUE, for example materials.skin.subsurface_radius=0.1 or render.seed=3")
        ->type_name("PATH=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

std::vector<io::Override> SceneOptions::overrides() const {
    std::vector<io::Override> result;
    for (const std::string &text : set) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos || equals == 0)
            throw Error(Exit::usage, "--set " + text, "is not PATH=VALUE, for example --set render.spp=16");
        result.push_back({text.substr(0, equals), text.substr(equals + 1)});
    }
    return result;
}

} // namespace nacre::app
