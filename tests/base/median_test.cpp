// SPDX-License-Identifier: MIT
#include "lixel/base/median.h"

#include "support/random_cases.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lixel {
namespace {

using test::forEachCase;
using test::Rng;

TEST(Median, IsTheMiddleOneOrTheMeanOfTheTwo)
{
    EXPECT_EQ(median({5}), 5);
    EXPECT_EQ(median({5, 1, 3}), 3);
    EXPECT_EQ(median({4, 1, 3, 2}), 2.5);
}

TEST(Median, HasAsManyValuesAboveAsBelowInAnyOrder)
{
    forEachCase(test::kCases, [](Rng& rng) {
        std::vector<double> values(std::size_t(rng.integer(1, 40)));
        for (double& value : values) value = rng.integer(0, 20);
        const double middle = median(values);
        const auto below = std::ranges::count_if(values, [&](double value) { return value < middle; });
        const auto above = std::ranges::count_if(values, [&](double value) { return value > middle; });
        EXPECT_LE(2 * below, std::ptrdiff_t(values.size()));
        EXPECT_LE(2 * above, std::ptrdiff_t(values.size()));
        std::ranges::reverse(values);
        EXPECT_EQ(median(values), middle);
    });
}

} // namespace
} // namespace lixel
