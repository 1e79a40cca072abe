#pragma once
#include "app/progress.h"
#include <chrono>
#include <string>

namespace nacre::bench {

/// Thrown between and in renders once SIGINT or SIGTERM has come.
struct Interrupted {};

/// Throws it.
void check_interrupt();

/// Shows on stderr how far the measurement of a scene is.
class Pace {
  public:
    /// What is about to be measured, "scene 1 of 9, bear", with `samples` per pixel in all its renders.
    void begin(std::string scene, double samples);

    /// Before a render of `spp`, "default, seed 1 of 16"; 0 spp if it is not among those samples, since what it takes
    /// says nothing of the others. Throws Interrupted.
    void next(std::string render, std::uint32_t spp);

    /// Again, while it takes long.
    void show();

    /// Before anything else is printed.
    void finish() { bar.finish(); }

  private:
    using Clock = std::chrono::steady_clock;

    app::ProgressBar bar{false, "error_time"};
    std::string scene, render;
    Clock::time_point start{};
    double samples = 0, done = 0, current = 0;
};

} // namespace nacre::bench
