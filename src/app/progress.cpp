#include "app/progress.h"
#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

namespace nacre::app {
namespace {

using namespace std::chrono_literals;

std::string duration(double seconds) {
    if (seconds < 60) return fmt::format("{:.0f} s", seconds);
    const int minutes = int(seconds / 60);
    if (minutes < 60) return fmt::format("{} min {:.0f} s", minutes, seconds - 60 * minutes);
    return fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

std::string describe(const render::Progress &p) {
    const double share = p.wanted > 0 ? double(p.samples) / double(p.wanted) : 1;
    const double left = share > 0 ? p.seconds * (1 - share) / share : 0;
    const double rate = p.seconds > 0 ? double(p.rays) / p.seconds : 0;
    return fmt::format("{:3.0f} %  {:.2f} of {:.2f} M samples  {:.2f} M rays/s  {} left", 100 * share,
                       double(p.samples) * 1e-6, double(p.wanted) * 1e-6, rate * 1e-6, duration(left));
}

} // namespace

ProgressBar::ProgressBar(bool quiet) : terminal(isatty(STDERR_FILENO)), quiet(quiet) {}

bool ProgressBar::due() {
    const auto now = std::chrono::steady_clock::now();
    if (quiet || now - last < (terminal ? 100ms : 5s)) return false;
    last = now;
    return true;
}

void ProgressBar::draw(double share, const std::string &text) {
    drawn = true;
    if (!terminal) {
        fmt::print(stderr, "nacre: {}\n", text);
        return;
    }
    const int cells = 24, full = int(cells * share);
    fmt::print(stderr, "\r[{:#<{}}{:.<{}}] {}\033[K", "", full, "", cells - full, text);
    std::fflush(stderr);
}

void ProgressBar::show(const render::Progress &progress) {
    if (due()) draw(double(progress.samples) / double(std::max<std::uint64_t>(1, progress.wanted)), describe(progress));
}

void ProgressBar::show(double share, const std::string &what) {
    if (due()) draw(share, fmt::format("{:3.0f} %  {}", 100 * share, what));
}

void ProgressBar::finish() {
    if (drawn && terminal) fmt::print(stderr, "\r\033[K");
}

} // namespace nacre::app
