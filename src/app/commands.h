#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace nacre::app {

/// A subcommand adds its options to `program` and returns what runs it; that returns the exit code or throws.
using Run = std::function<int()>;
Run add_render(CLI::App &program);
Run add_devices(CLI::App &program);
Run add_check(CLI::App &program);
Run add_profile(CLI::App &program);
Run add_sheet(CLI::App &program);
Run add_albedo(CLI::App &program);
Run add_compare(CLI::App &program);

} // namespace nacre::app
