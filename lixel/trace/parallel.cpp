// SPDX-License-Identifier: MIT
#include "lixel/trace/parallel.h"

#include "lixel/base/assert.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace lixel {
namespace {

thread_local LoopWatch* watchOfThread = nullptr;

} // namespace

// A loop as its thread's watch sees it. Loops within it are not watched.
class WatchedLoop
{
public:
    explicit WatchedLoop(std::size_t blocks) : watch_(std::exchange(watchOfThread, nullptr))
    {
        if (!watch_) return;
        const std::lock_guard lock(watch_->mutex_);
        watch_->blocks_ = blocks;
        watch_->begin_ = std::chrono::steady_clock::now();
        watch_->done_ = 0;
    }
    WatchedLoop(const WatchedLoop&) = delete;
    WatchedLoop& operator=(const WatchedLoop&) = delete;
    ~WatchedLoop()
    {
        if (!watch_) return;
        const std::lock_guard lock(watch_->mutex_);
        watch_->blocks_ = 0;
        watchOfThread = watch_;
    }

    void blockDone() const
    {
        if (watch_) watch_->done_.fetch_add(1, std::memory_order_relaxed);
    }

private:
    LoopWatch* watch_;
};

LoopWatch::LoopWatch() : before_(std::exchange(watchOfThread, this)) {}

LoopWatch::~LoopWatch() { watchOfThread = before_; }

std::optional<LoopWatch::State> LoopWatch::running() const
{
    const std::lock_guard lock(mutex_);
    if (blocks_ == 0) return std::nullopt;
    return State{double(done_.load(std::memory_order_relaxed)) / double(blocks_), begin_};
}

void forEachBlock(std::size_t count, std::size_t blockSize, const std::function<void(std::size_t, std::size_t)>& body)
{
    LX_ASSERT(blockSize > 0);
    const std::size_t blocks = (count + blockSize - 1) / blockSize;
    std::atomic<std::size_t> next = 0;
    std::exception_ptr failure;
    std::mutex failureMutex;
    const WatchedLoop loop(blocks);
    const auto work = [&] {
        for (std::size_t block = next++; block < blocks; block = next++) {
            try {
                body(block * blockSize, std::min(count, (block + 1) * blockSize));
                loop.blockDone();
            } catch (...) {
                const std::lock_guard lock(failureMutex);
                if (!failure) failure = std::current_exception();
                next = blocks;
            }
        }
    };
    const std::size_t helpers = std::min<std::size_t>(std::max(1u, std::thread::hardware_concurrency()), blocks);
    std::vector<std::jthread> threads;
    for (std::size_t i = 1; i < helpers; ++i) threads.emplace_back(work);
    work();
    threads.clear();
    if (failure) std::rethrow_exception(failure);
}

} // namespace lixel
