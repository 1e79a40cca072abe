#pragma once
#include "app/albedo_options.h"
#include "app/commands.h"

namespace nacre::app {

// The subcommands of `nacre albedo`.
Run add_albedo_chart(CLI::App &albedo);
Run add_albedo_build(CLI::App &albedo);
Run add_albedo_fit(CLI::App &albedo);

} // namespace nacre::app
