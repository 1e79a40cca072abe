#include "app/progress.h"
#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

namespace nacre::app {
namespace {

using namespace std::chrono_literals;

/// What ends the render first says how far it is: samples or time.
double share_of(const render::Progress &p) {
    const double samples = double(p.samples) / double(std::max<std::uint64_t>(1, p.wanted));
    return std::clamp(p.until > 0 ? std::max(samples, p.sampling / p.until) : samples, 0.0, 1.0);
}

std::string describe(const render::Progress &p) {
    const double share = share_of(p), left = share > 0 ? p.seconds * (1 - share) / share : 0;
    const double rate = p.seconds > 0 ? double(p.rays) / p.seconds : 0, samples = double(p.samples) * 1e-6;
    const std::string done = p.until > 0
                                 ? fmt::format("{:.1f} of {:g} s  {:.2f} M samples", p.sampling, p.until, samples)
                                 : fmt::format("{:.2f} of {:.2f} M samples", samples, double(p.wanted) * 1e-6);
    return fmt::format("{:3.0f} %  {}  {:.2f} M rays/s  {} left", 100 * share, done, rate * 1e-6, duration(left));
}

} // namespace

std::string duration(double seconds) {
    if (seconds < 60) return fmt::format("{:.0f} s", seconds);
    const int minutes = int(seconds / 60);
    if (minutes < 60) return fmt::format("{} min {:.0f} s", minutes, seconds - 60 * minutes);
    return fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

ProgressBar::ProgressBar(bool quiet, std::string program)
    : terminal(isatty(STDERR_FILENO)), quiet(quiet), program(std::move(program)) {}

bool ProgressBar::due() {
    const auto now = std::chrono::steady_clock::now();
    if (quiet || now - last < (terminal ? 100ms : 5s)) return false;
    last = now;
    return true;
}

void ProgressBar::draw(double share, const std::string &text) {
    drawn = true;
    if (!terminal) {
        fmt::print(stderr, "{}: {}\n", program, text);
        return;
    }
    const int cells = 24, full = int(cells * share);
    fmt::print(stderr, "\r[{:#<{}}{:.<{}}] {}\033[K", "", full, "", cells - full, text);
    std::fflush(stderr);
}

void ProgressBar::show(const render::Progress &progress) {
    if (due()) draw(share_of(progress), describe(progress));
}

void ProgressBar::show(double share, const std::string &what) {
    if (due()) draw(share, fmt::format("{:3.0f} %  {}", 100 * share, what));
}

void ProgressBar::finish() {
    if (drawn && terminal) fmt::print(stderr, "\r\033[K");
}

} // namespace nacre::app
