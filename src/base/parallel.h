#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace nacre {

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
    const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
    for (std::size_t i = 1; i < std::min(cores, count); i++) helpers.emplace_back(work);
    work();
    helpers.clear(); // waits for them
    if (error) std::rethrow_exception(error);
}

} // namespace nacre
