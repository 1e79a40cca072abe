#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#if defined(__linux__)
#include <sched.h>
#endif

namespace nacre {

/// Cores that this thread may run on. glibc's count, and so the library's, leaves out what taskset and containers say.
inline std::size_t usable_cores() {
#if defined(__linux__)
    cpu_set_t set;
    if (sched_getaffinity(0, sizeof set, &set) == 0) return static_cast<std::size_t>(CPU_COUNT(&set));
#endif
    return std::max(1u, std::thread::hardware_concurrency());
}

/// Calls f(0), ..., f(count - 1) on all cores, in no particular order, and returns when all are done. Each call should
/// be worth some 10 us. Of what the calls throw, one exception comes out, and calls not yet begun are dropped.
template <typename F> void parallel_for(std::size_t count, const F &f) {
    std::atomic<std::size_t> next{0};
    std::exception_ptr error;
    std::mutex guard;
    const auto work = [&] {
        try {
            for (std::size_t i; (i = next++) < count;) f(i);
        } catch (...) {
            const std::lock_guard lock(guard);
            error = std::current_exception();
            next = count;
        }
    };
    std::vector<std::jthread> helpers;
    const std::size_t threads = std::min(usable_cores(), count);
    for (std::size_t i = 1; i < threads; i++) helpers.emplace_back(work);
    work();
    helpers.clear(); // waits for them
    if (error) std::rethrow_exception(error);
}

} // namespace nacre
