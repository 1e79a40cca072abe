#pragma once
#include "error_time/scenarios.h"
#include "error_time/shots.h"

namespace nacre::bench {

/// What another renderer made of a scene, or a line that says why it made nothing.
struct PeerShots {
    Series series;
    std::vector<compare::Estimate> references;
    std::string why_not;
};

/// Those that `shoot_peer` knows.
std::vector<std::string> peer_names();

/// Renders the scene with `bench/peers/NAME.py`, with as many threads as this machine has. Seconds are those of its
/// sampling alone, as far as its clock tells: what a picture of the largest budget takes longer than one of the
/// smallest with the same seed, per sample, times the samples. Throws Interrupted.
PeerShots shoot_peer(const std::string &name, const Scenario &scenario, const std::vector<std::uint32_t> &budgets,
                     std::uint32_t seeds, Pace &pace);

/// Writes what other renderers need to folder: scene.json, and numbers as little-endian files beside it.
/// Returns why the scene has no equal there, or nothing.
std::string export_scene(const std::string &folder, const scene::Scene &scene);

} // namespace nacre::bench
