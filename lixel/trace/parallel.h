// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>

namespace lixel {

// Calls body(first, last) for consecutive blocks of [0, count) on all processors, in no particular order, and waits for
// all. Bodies write to places of their own only, so that results do not depend on the threads. The first exception is
// rethrown.
void forEachBlock(std::size_t count, std::size_t blockSize, const std::function<void(std::size_t, std::size_t)>& body);

// How far the loop is that a thread runs by forEachBlock(), for those who wait. Watches the thread that makes it, one at a time;
// may be asked from any thread.
class LoopWatch
{
public:
    LoopWatch();
    LoopWatch(const LoopWatch&) = delete;
    LoopWatch& operator=(const LoopWatch&) = delete;
    ~LoopWatch();

    struct State
    {
        double share = 0; // done, 0 to 1
        std::chrono::steady_clock::time_point begin;
    };
    std::optional<State> running() const; // nothing between loops

private:
    friend class WatchedLoop;

    LoopWatch* before_;
    mutable std::mutex mutex_;
    std::size_t blocks_ = 0; // of the running loop; 0: none
    std::chrono::steady_clock::time_point begin_;
    std::atomic<std::size_t> done_ = 0;
};

} // namespace lixel
