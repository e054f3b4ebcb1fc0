// SPDX-License-Identifier: MIT
#include "lixel/judge/best_front.h"

#include "support/random_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace lixel {
namespace {

using namespace test;

TEST(BestFront, HoldsJustWhatNoOtherBeatsFromTheCheapestOn)
{
    forEachCase(kCases, [](Rng& rng) {
        std::vector<double> cost, error;
        for (int i = rng.integer(0, 20); i > 0; --i) {
            cost.push_back(rng.integer(0, 8)); // equal ones among them
            error.push_back(rng.chance(0.1) ? std::numeric_limits<double>::quiet_NaN() : rng.integer(0, 8));
        }
        const std::vector<std::size_t> front = bestFront(cost, error);
        const auto isBeaten = [&](std::size_t i) {
            for (std::size_t j = 0; j < cost.size(); ++j)
                if ((cost[j] <= cost[i] && error[j] < error[i]) || (cost[j] < cost[i] && error[j] <= error[i]))
                    return true;
            return false;
        };
        for (std::size_t i = 0; i < cost.size(); ++i) {
            const bool isOnIt = std::ranges::find(front, i) != front.end();
            EXPECT_EQ(isOnIt, error[i] == error[i] && !isBeaten(i));
        }
        for (std::size_t k = 1; k < front.size(); ++k) {
            EXPECT_LE(cost[front[k - 1]], cost[front[k]]);
            EXPECT_GE(error[front[k - 1]], error[front[k]]);
        }
    });
}

} // namespace
} // namespace lixel
