#include "error_time/pace.h"
#include "app/interrupt.h"
#include <fmt/format.h>

namespace nacre::bench {

void check_interrupt() {
    if (app::interrupted) throw Interrupted{};
}

void Pace::begin(std::string what, double all) {
    scene = std::move(what);
    samples = all;
    done = current = 0;
}

void Pace::next(std::string what, std::uint32_t spp) {
    check_interrupt();
    render = std::move(what);
    done += current;
    current = spp;
    if (done == 0) start = Clock::now(); // what compiled until now does so once
    show();
}

void Pace::show() {
    const double share = done / samples, spent = std::chrono::duration<double>(Clock::now() - start).count();
    const std::string left = share > 0 && share < 1 ? ", " + app::duration(spent * (1 - share) / share) + " left" : "";
    bar.show(share, fmt::format("{}: {}{}", scene, render, left));
}

} // namespace nacre::bench
