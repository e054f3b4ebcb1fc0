// SPDX-License-Identifier: MIT
#include "lixel/judge/smallest_map.h"

#include "support/random_cases.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <gtest/gtest.h>

namespace lixel {
namespace {

using test::forEachCase;
using test::kCases;
using test::Rng;

TEST(SmallestMap, LadderHasStepsOfTwoPercentOrOneLixel)
{
    const std::vector<int> sides = ladderOfSides();
    EXPECT_EQ(sides.front(), kSmallestSide);
    EXPECT_EQ(sides.back(), kLargestSide);
    for (std::size_t i = 1; i < sides.size(); ++i) {
        EXPECT_GT(sides[i], sides[i - 1]);
        EXPECT_LE(sides[i] - sides[i - 1], std::max(1.0, 0.02 * sides[i - 1] + 1)) << sides[i];
    }
}

// Two measured maps tell all.
TEST(SmallestMap, OfErrorsThatGoWithOneOverSideOverAFloorIsWherePredicted)
{
    forEachCase(kCases, [](Rng& rng) {
        const double scale = rng.uniform(20, 2000), tolerance = 0.5, floor = rng.uniform(0, 0.2);
        const SmallestMap found =
            smallestMap(tolerance, int(rng.uniform(8, 8192)), [&](int side) { return floor + scale / side; });
        ASSERT_TRUE(found.side);
        EXPECT_LE(found.percent, tolerance);
        EXPECT_EQ(found.predicted, *found.side);
        EXPECT_LE(*found.side, std::max(scale / (tolerance - floor) * 1.03 + 1, 8.0));
        EXPECT_LE(found.measured, 6);
    });
}

// What it says of itself, of errors that rise and fall by chance.
TEST(SmallestMap, HoldsFromItsSideOnAndNotBefore)
{
    const std::vector<int> sides = ladderOfSides();
    forEachCase(kCases, [&](Rng& rng) {
        const double scale = rng.uniform(20, 2000), tolerance = 0.5;
        std::map<int, double> errors;
        for (const int side : sides) errors[side] = scale / std::pow(side, rng.uniform(0.97, 1.03));
        const SmallestMap found =
            smallestMap(tolerance, int(rng.uniform(8, 8192)), [&](int side) { return errors.at(side); });
        ASSERT_TRUE(found.side);
        EXPECT_EQ(found.percent, errors.at(*found.side));
        const auto at = std::find(sides.begin(), sides.end(), *found.side);
        for (auto i = at; i != sides.end() && i < at + 3; ++i) EXPECT_LE(errors.at(*i), tolerance);
        if (at != sides.begin()) {
            EXPECT_GT(errors.at(at[-1]), tolerance);
        }
    });
}

TEST(SmallestMap, IsNoneWhereTheLargestMissesTheTolerance)
{
    const SmallestMap none = smallestMap(0.5, 512, [](int side) { return 8192.0 / side; });
    EXPECT_FALSE(none.side);
    EXPECT_EQ(none.percent, 1);
    EXPECT_EQ(none.predicted, kLargestSide);
    EXPECT_FALSE(smallestMap(0.5, 512, [](int) { return std::numeric_limits<double>::infinity(); }).side);
}

TEST(SmallestMap, IsTheSmallestOfTheLadderWithoutErrors)
{
    EXPECT_EQ(smallestMap(0.5, 512, [](int) { return 0.0; }).side, kSmallestSide);
}

} // namespace
} // namespace lixel
