#include "app/interrupt.h"
#include <csignal>

namespace nacre::app {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler writes it");

void catch_interrupts() {
    const auto handler = [](int signal) {
        interrupted.store(true);
        std::signal(signal, SIG_DFL);
    };
    std::signal(SIGINT, handler);
    std::signal(SIGTERM, handler);
}

} // namespace nacre::app
