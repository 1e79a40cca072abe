#pragma once
#include "error_time/analysis.h"
#include <filesystem>
#include <nlohmann/json.hpp>

namespace nacre::bench {

/// What was measured of one scene. The first of `modes` is the default; peers have references of their own.
struct SceneReport {
    std::string name, shows;
    int width = 0, height = 0;
    std::uint32_t reference_spp = 0; // of all its renders
    std::vector<Result> modes, peers;
};

struct Report {
    std::string device;
    std::vector<std::string> remarks; // what is left out, and why
    std::vector<SceneReport> scenes;
};

nlohmann::ordered_json to_json(const Report &report);

/// One line per picture. Throws Error{Exit::output}, as below.
void write_csv(const std::string &file, const Report &report);

/// Plots and tables in one file that needs no other.
void write_page(const std::string &file, const Report &report);

/// For the terminal.
void print(const SceneReport &scene);

} // namespace nacre::bench
