#pragma once
#include "error_time/analysis.h"
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

/// One line per picture.
std::string to_csv(const Report &report);

/// Plots and tables in one HTML file that needs no other.
std::string to_page(const Report &report);

/// For the terminal.
void print(const SceneReport &scene);

} // namespace nacre::bench
