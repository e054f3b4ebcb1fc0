// SPDX-License-Identifier: MIT
#include "lixel/trace/parallel.h"

#include "lixel/base/assert.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace lixel {

void forEachBlock(std::size_t count, std::size_t blockSize, const std::function<void(std::size_t, std::size_t)>& body)
{
    LX_ASSERT(blockSize > 0);
    const std::size_t blocks = (count + blockSize - 1) / blockSize;
    std::atomic<std::size_t> next = 0;
    std::exception_ptr failure;
    std::mutex failureMutex;
    const auto work = [&] {
        for (std::size_t block = next++; block < blocks; block = next++) {
            try {
                body(block * blockSize, std::min(count, (block + 1) * blockSize));
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
