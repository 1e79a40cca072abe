#pragma once
#include "render/session.h"
#include <chrono>

namespace nacre::app {

/// "5 s", "2 min 5 s", "1 h 2 min".
std::string duration(double seconds);

/// Shows how far a render is: a bar that is redrawn on a terminal, a line every few seconds elsewhere, nothing if
/// quiet.
class ProgressBar {
  public:
    /// `program`: what a line begins with where there is no terminal.
    explicit ProgressBar(bool quiet, std::string program = "nacre");
    void show(const render::Progress &progress);
    void show(double share, const std::string &what); // 0 .. 1 of something else than samples
    void finish();

  private:
    bool due();
    void draw(double share, const std::string &text);

    bool terminal, quiet, drawn = false;
    std::string program;
    std::chrono::steady_clock::time_point last{};
};

} // namespace nacre::app
