// SPDX-License-Identifier: MIT
#include "lixel/trace/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

namespace lixel {
namespace {

TEST(Parallel, EveryNumberIsInOneBlock)
{
    for (const std::size_t count : {0u, 1u, 99u, 100u, 101u, 1000u}) {
        std::vector<int> visits(count);
        forEachBlock(count, 100, [&](std::size_t first, std::size_t last) {
            EXPECT_EQ(first % 100, 0u);
            EXPECT_LE(last - first, 100u);
            for (std::size_t i = first; i < last; ++i) ++visits[i];
        });
        EXPECT_EQ(visits, std::vector<int>(count, 1));
    }
}

TEST(Parallel, AWatchSeesTheSharesOfItsThreadsLoop)
{
    const LoopWatch watch;
    EXPECT_FALSE(watch.running());
    std::atomic<int> within = 0;
    forEachBlock(100, 1, [&](std::size_t, std::size_t) {
        const auto state = watch.running();
        if (state && state->share >= 0 && state->share < 1) ++within;
    });
    EXPECT_EQ(within, 100);
    EXPECT_FALSE(watch.running());
    EXPECT_THROW(forEachBlock(4, 1, [](std::size_t, std::size_t) { throw std::runtime_error("stop"); }),
                 std::runtime_error);
    EXPECT_FALSE(watch.running());
}

TEST(Parallel, LoopsWithinLoopsAndOfOtherThreadsAreNotWatched)
{
    const LoopWatch watch;
    forEachBlock(2, 1, [&](std::size_t, std::size_t) {
        forEachBlock(50, 1, [](std::size_t, std::size_t) {});
        EXPECT_TRUE(watch.running() && watch.running()->share < 1);
    });
    std::jthread([&] { forEachBlock(2, 1, [&](std::size_t, std::size_t) { EXPECT_FALSE(watch.running()); }); }).join();
    {
        const LoopWatch inner;
        forEachBlock(2, 1, [&](std::size_t, std::size_t) { EXPECT_FALSE(watch.running()); });
    }
    forEachBlock(2, 1, [&](std::size_t, std::size_t) { EXPECT_TRUE(watch.running()); });
}

} // namespace
} // namespace lixel
