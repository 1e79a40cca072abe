#pragma once
#include <atomic>

namespace nacre::app {

/// Set by the first SIGINT or SIGTERM; the second one ends the program.
extern std::atomic<bool> interrupted;
void catch_interrupts();

} // namespace nacre::app
