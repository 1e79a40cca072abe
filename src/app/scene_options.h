#pragma once
#include "io/load.h"
#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

namespace nacre::app {

/// SCENE and --set, as every subcommand that reads a scene has them.
struct SceneOptions {
    std::string file;
    std::vector<std::string> set;

    void add_to(CLI::App &command);
    /// Throws Error{Exit::usage} for a --set that is not path=value.
    std::vector<io::Override> overrides() const;
};

} // namespace nacre::app
