#include "app/stopwatch.h"

namespace nacre::app {

Stopwatch::Stopwatch(bool trace) {
    if (trace) spans.emplace();
}

scene::Scene Stopwatch::load(const RenderOptions &options) {
    const Span span(timeline(), "load scene", &load_seconds);
    scene::Scene scene = io::load_scene(options.scene.file, options.scene.overrides());
    options.apply(scene);
    return scene;
}

device::Device Stopwatch::open_device(const RenderOptions &options) {
    const Span span(timeline(), "open device", &device_seconds);
    return options.open_device();
}

render::Statistics Stopwatch::complete(render::Statistics statistics) const {
    statistics.startup.load = load_seconds;
    statistics.startup.device = device_seconds;
    statistics.startup.first_pixel += load_seconds + device_seconds;
    statistics.total = std::chrono::duration<double>(Timeline::Clock::now() - start).count();
    return statistics;
}

} // namespace nacre::app
