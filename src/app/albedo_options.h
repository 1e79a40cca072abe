#pragma once
#include "device/context.h"
#include "scene/scene.h"
#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace nacre::app {

/// A medium on the command line: what the subcommands of `nacre albedo` are asked about.
struct AlbedoOptions {
    std::string color, g = "0", flight = "renewal", entry = "lambert", inversion = "table", device;
    double bleed = 0;
    std::uint32_t max_depth = 0;
    double error = 1e-3;
    bool check = false, as_json = false, quiet = false;

    void add_medium_to(CLI::App &command);
    void add_device_to(CLI::App &command);

    /// With the fields of a scene's material and their ranges. Throws Error{Exit::usage}.
    scene::Material material() const;
    device::Device open_device() const { return device::open_device(device); }
};

} // namespace nacre::app
