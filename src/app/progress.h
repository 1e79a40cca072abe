#pragma once
#include "render/session.h"
#include <chrono>

namespace nacre::app {

/// Shows how far a render is: a bar that is redrawn on a terminal, a line every few seconds elsewhere, nothing if
/// quiet.
class ProgressBar {
  public:
    explicit ProgressBar(bool quiet);
    void show(const render::Progress &progress);
    void show(double share, const std::string &what); // 0 .. 1 of something else than samples
    void finish();

  private:
    bool due();
    void draw(double share, const std::string &text);

    bool terminal, quiet, drawn = false;
    std::chrono::steady_clock::time_point last{};
};

} // namespace nacre::app
