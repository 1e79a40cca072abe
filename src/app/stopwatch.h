#pragma once
#include "app/render_options.h"
#include "base/timeline.h"
#include <optional>

namespace nacre::app {

/// Times what a command does around its session, from its first line on.
class Stopwatch {
  public:
    /// With a timeline only if it is asked for.
    explicit Stopwatch(bool trace);

    /// Null without one.
    Timeline *timeline() { return spans ? &*spans : nullptr; }

    scene::Scene load(const RenderOptions &options);
    device::Device open_device(const RenderOptions &options);

    /// The session's statistics with what came before it.
    render::Statistics complete(render::Statistics statistics) const;

  private:
    Timeline::Clock::time_point start = Timeline::Clock::now();
    std::optional<Timeline> spans;
    double load_seconds = 0, device_seconds = 0;
};

} // namespace nacre::app
